// Makes the scenes of the contract suite.
#include "tool/contract/scenes.hpp"

namespace passgraph::tool::contract {
namespace {

Light sun(glm::vec3 color, glm::vec3 direction)
{
    Light light;
    light.kind = Light::Kind::directional;
    light.color = color;
    light.direction = direction;
    return light;
}

Light lamp(glm::vec3 color, glm::vec3 position, float radius)
{
    Light light;
    light.kind = Light::Kind::point;
    light.color = color;
    light.position = position;
    light.radius = radius;
    return light;
}

Light spot(Light lamp, glm::vec3 direction, float inner, float outer)
{
    lamp.kind = Light::Kind::spot;
    lamp.direction = direction;
    lamp.inner_angle = inner;
    lamp.outer_angle = outer;
    return lamp;
}

Scene with_material(Scene scene)
{
    scene.materials.push_back({});
    Mesh mesh;
    for (const glm::vec2 corner : {glm::vec2(-1, -1), glm::vec2(1, -1), glm::vec2(0, 1)})
        mesh.vertices.push_back({{corner, -3.0f}, {0.0f, 0.0f, 1.0f}, 0.5f + 0.5f * corner});
    mesh.indices = {0, 1, 2};
    scene.meshes.push_back(mesh);
    scene.elements.push_back({});
    return scene;
}

void add(Scene& scene, const std::vector<Vertex>& vertices)
{
    Mesh mesh;
    mesh.vertices = vertices;
    for (std::uint32_t i = 0; i + 2 < vertices.size(); ++i)
        mesh.indices.insert(mesh.indices.end(), {0, i + 1, i + 2});
    scene.elements.push_back({.name = "", .mesh = static_cast<int>(scene.meshes.size())});
    scene.meshes.push_back(std::move(mesh));
}

/// A quad two metres away, its four corners' normals given.
void add_quad(Scene& scene, float x, float y, const std::array<glm::vec3, 4>& normals)
{
    constexpr float kSize = 0.4f;
    const std::array<glm::vec2, 4> corners = {{{0, 0}, {kSize, 0}, {kSize, kSize}, {0, kSize}}};
    std::vector<Vertex> vertices;
    for (size_t i = 0; i < 4; ++i)
        vertices.push_back({{x + corners[i].x, y + corners[i].y, -2.0f}, normals[i], corners[i] * 2.0f});
    add(scene, vertices);
}

} // namespace

Scene unlit_scene() { return with_material({}); }

Scene lit_scene()
{
    Scene scene = with_material({});
    scene.lights = {sun({1.0f, 0.9f, 0.8f}, {0.0f, -1.0f, 0.0f}), lamp({2.0f, 2.0f, 2.0f}, {0.5f, 1.0f, -2.0f}, 5.0f),
                    lamp({0.1f, 0.0f, 50.0f}, {-3.0f, 0.0f, -8.0f}, 100.0f),
                    spot(lamp({5.0f, 5.0f, 1.0f}, {0.0f, 3.0f, -4.0f}, 20.0f), {0.0f, -1.0f, 0.0f}, 0.2f, 0.9f)};
    return scene;
}

Scene hard_scene()
{
    Scene scene = with_material({});
    scene.lights = {lamp({1.0f, 1.0f, 1.0f}, {0.0f, 0.0f, 0.0f}, 10.0f), // where pixels without geometry are
                    lamp({1.0f, 1.0f, 1.0f}, {0.0f, 0.0f, -1000.0f}, 0.0f),
                    lamp({65504.0f, 65504.0f, 65504.0f}, {0.0f, 0.0f, -1000.0f}, 1e6f),
                    sun({65504.0f, 65504.0f, 65504.0f}, {0.0f, 0.0f, -1.0f}), sun({1.0f, 1.0f, 1.0f}, {0.0f, 0.0f, 1.0f}),
                    lamp({1.0f, 1.0f, 1.0f}, {1e6f, 1e6f, -1e6f}, 1e7f),
                    // Cones without an axis, of equal angles, of none at all, and open all around.
                    spot(lamp({1.0f, 1.0f, 1.0f}, {0.0f, 0.0f, -1.0f}, 1e4f), {0.0f, 0.0f, 0.0f}, 0.3f, 0.6f),
                    spot(lamp({1.0f, 1.0f, 1.0f}, {0.0f, 1.0f, 0.0f}, 1e4f), {0.0f, 0.0f, -1.0f}, 0.5f, 0.5f),
                    spot(lamp({1.0f, 1.0f, 1.0f}, {0.0f, 0.0f, 0.0f}, 1e4f), {0.0f, 0.0f, -1.0f}, 0.0f, 0.0f),
                    spot(lamp({1.0f, 1.0f, 1.0f}, {0.0f, 0.0f, 0.0f}, 1e4f), {0.0f, -1.0f, 0.0f}, 3.1415927f, 3.1415927f)};
    return scene;
}

Scene hard_meshes()
{
    Scene scene;
    scene.materials.push_back({});
    const glm::vec3 none(0.0f);
    const glm::vec3 front(0.0f, 0.0f, 1.0f);
    const glm::vec3 right(1.0f, 0.0f, 0.0f);
    add_quad(scene, -0.8f, -0.8f, {none, none, none, none});
    add_quad(scene, -0.3f, -0.8f, {right, -right, right, -right});
    add_quad(scene, 0.2f, -0.8f, {front * 1e-20f, front * 1e-20f, right * 1e-20f, front * 1e-20f});
    add_quad(scene, -0.8f, -0.3f, {front * 1e20f, front * 1e20f, right * 1e20f, front * 1e20f});
    add_quad(scene, -0.3f, -0.3f, {front, -front, front, -front});
    add_quad(scene, 0.2f, -0.3f, {-front, -front, -front, -front});
    const auto at = [&](float x, float y, float z) { return Vertex{{x, y, z}, front, {x, y}}; };
    add(scene, {at(-0.5f, 0.5f, -1.0f), at(0.5f, 0.5f, -1.0f), at(0.5f, 0.5f, -1.0f)}); // without area
    add(scene, {at(-2.0f, 0.3f, -4.0f), at(2.0f, 0.3f, -4.0f), at(0.0f, 0.4f, 1.0f)});  // through the near plane
    add(scene, {at(-2.0f, 0.0f, 2.0f), at(2.0f, 0.0f, 2.0f), at(0.0f, 1.0f, 3.0f)});    // behind the viewer
    return scene;
}

} // namespace passgraph::tool::contract
