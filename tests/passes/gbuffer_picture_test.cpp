// The G-buffer of one square: what it stores, and that hard normals and transforms leave it finite.
#include <cmath>
#include <map>
#include <string>

#include <glm/glm.hpp>

#include <passgraph/core/compile.hpp>
#include <passgraph/gl/renderer.hpp>
#include <passgraph/scene/scene.hpp>

#include "passes/expected.hpp"
#include "support/catch.hpp"
#include "support/test_context.hpp"

using namespace passgraph;
using namespace passgraph::test;

namespace {

constexpr Extent kExtent{16, 16};

/// A square of 2 m, 2 m before the camera, that fills the picture (45 degrees show 1.66 m there).
Scene square(glm::vec3 left_normal, glm::vec3 right_normal)
{
    Scene scene;
    scene.materials.push_back({.name = "glaze", .base_color = {0.8f, 0.5f, 0.2f, 1.0f}, .metallic = 0.25f, .roughness = 0.75f, .specular = 0.5f, .emissive = {0.0f, 1.0f, 2.0f}});
    Mesh mesh;
    for (const glm::vec2 corner : {glm::vec2(-1, -1), glm::vec2(1, -1), glm::vec2(1, 1), glm::vec2(-1, 1)})
        mesh.vertices.push_back({{corner, -2.0f}, corner.x < 0.0f ? left_normal : right_normal, glm::vec2(0.0f)});
    mesh.indices = {0, 1, 2, 0, 2, 3};
    scene.meshes.push_back(mesh);
    scene.elements.push_back({.name = "square", .mesh = 0, .world_from_model = glm::mat4(1.0f)});
    return scene;
}

/// Every output but depth, in binary32.
std::map<std::string, Picture> drawn(const Scene& scene)
{
    const std::string kOutputs[] = {"albedo", "material", "normal", "position", "emissive"};
    Graph graph;
    PassArguments arguments;
    arguments.name = "surface";
    arguments.inputs.push_back({"scene", graph.scene().elements});
    for (const std::string& output : kOutputs)
        arguments.codecs.push_back({output, {}, "rgba32f", {}});
    const AddedPass surface = graph.add("gbuffer", std::move(arguments));
    for (const std::string& output : kOutputs)
        graph.output(output, surface[output]);
    CompileOptions options;
    options.extent = kExtent;
    const auto plan = compile(graph, options);
    if (!plan)
        FAIL(to_text(plan.error()));
    RendererOptions renderer_options;
    renderer_options.loader = test_context().loader();
    auto renderer = Renderer::create(*plan, renderer_options);
    if (!renderer)
        FAIL(to_text(renderer.error()));
    REQUIRE(renderer->set_scene(scene));
    REQUIRE(renderer->render());
    std::map<std::string, Picture> pictures;
    for (const std::string& output : kOutputs)
        pictures[output] = *renderer->read(output);
    return pictures;
}

const glm::vec3 kFacing{0.0f, 0.0f, 1.0f};

// The atlas holds factors in 8 bits: half a code of material, and of sRGB where its slope is steepest among these values,
// 2.4 / 1.055 * ((0.906 + 0.055) / 1.055)^1.4 = 2.0 at 0.8; the sampler's and the decoding's roundings are 1e-3 of that.
constexpr double kMaterialCode = 0.501 / 255.0;
constexpr double kAlbedoCode = 2.0 * 0.501 / 255.0;

void require_all(const Picture& picture, std::array<double, 3> value, double tolerance)
{
    require_texels(picture, [&](int, int, int c) { return value[static_cast<size_t>(c)]; }, tolerance);
}

} // namespace

TEST_CASE("the G-buffer holds a square's color, matter, direction, place and light", "[passes][gbuffer]")
{
    const auto got = drawn(square(kFacing, kFacing));
    require_all(got.at("albedo"), {0.8, 0.5, 0.2}, kAlbedoCode);
    require_all(got.at("material"), {0.5, 0.75, 0.25}, kMaterialCode);
    require_all(got.at("normal"), {0.0, 0.0, 1.0}, 8.0 * kRounding);
    require_all(got.at("emissive"), {0.0, 1.0, 2.0}, 8.0 * kRounding);
    const double half_height = 2.0 * std::tan(0.5 * 0.785398163);
    const auto place = [&](int x, int y, int c) { return c == 2 ? -2.0 : ((c == 0 ? x : y) + 0.5 - 8.0) / 8.0 * half_height; };
    // Corners are snapped to 1/256 of a pixel, which is 0.104 m wide there.
    require_texels(got.at("position"), place, 0.104 / 256.0);
}

TEST_CASE("a pixel that no surface covers keeps a position of 0", "[passes][gbuffer]")
{
    Scene scene = square(kFacing, kFacing);
    scene.elements.clear();
    require_all(drawn(scene).at("position"), {0.0, 0.0, 0.0}, 0.0);
}

TEST_CASE("alpha is not blended with what was there, as it was in the original", "[passes][gbuffer][defect 1]")
{
    Scene scene = square(kFacing, kFacing);
    const auto opaque = drawn(scene);
    scene.materials[0].base_color.a = 0.25f;
    for (const auto& [name, picture] : drawn(scene))
        require_same(picture, opaque.at(name));
}

TEST_CASE("a mesh without normals faces the screen", "[passes][gbuffer]")
{
    require_all(drawn(square(glm::vec3(0.0f), glm::vec3(0.0f))).at("normal"), {0.0, 0.0, 1.0}, 8.0 * kRounding);
}

TEST_CASE("opposite normals that meet leave a direction everywhere", "[passes][gbuffer]")
{
    const Picture normal = drawn(square({1.0f, 0.0f, 0.0f}, {-1.0f, 0.0f, 0.0f})).at("normal");
    for (int y = 0; y < kExtent.height; ++y) {
        for (int x = 0; x < kExtent.width; ++x) {
            const glm::dvec3 n(normal.at(x, y, 0), normal.at(x, y, 1), normal.at(x, y, 2));
            CHECK(glm::length(n) == Approx(1.0).margin(8.0 * kRounding));
        }
    }
}

TEST_CASE("the back of a double-sided square faces the viewer too", "[passes][gbuffer]")
{
    Scene scene = square(-kFacing, -kFacing);
    scene.meshes[0].indices = {0, 2, 1, 0, 3, 2};
    scene.materials[0].is_double_sided = true;
    require_all(drawn(scene).at("normal"), {0.0, 0.0, 1.0}, 8.0 * kRounding);
}

TEST_CASE("a mirrored square is lit from the side that is seen", "[passes][gbuffer]")
{
    Scene scene = square(kFacing, kFacing);
    scene.elements[0].world_from_model[0][0] = -1.0f;
    for (const bool is_double_sided : {false, true}) {
        scene.materials[0].is_double_sided = is_double_sided;
        const auto got = drawn(scene);
        require_all(got.at("normal"), {0.0, 0.0, 1.0}, 8.0 * kRounding);
        require_all(got.at("albedo"), {0.8, 0.5, 0.2}, kAlbedoCode);
    }
}

TEST_CASE("a square scaled flat keeps its direction, a stretched one too", "[passes][gbuffer]")
{
    Scene scene = square(kFacing, kFacing);
    for (auto& vertex : scene.meshes[0].vertices)
        vertex.position.z = 0.0f;
    glm::dmat4& place = scene.elements[0].world_from_model;
    place[3] = glm::vec4(0.0f, 0.0f, -2.0f, 1.0f);
    for (const float thickness : {0.0f, 1e-3f, 1e3f}) {
        place[2][2] = thickness;
        require_all(drawn(scene).at("normal"), {0.0, 0.0, 1.0}, 8.0 * kRounding);
    }
}

TEST_CASE("normals of any length weigh the same between vertices", "[passes][gbuffer]")
{
    require_all(drawn(square(1e-8f * kFacing, 1e-8f * kFacing)).at("normal"), {0.0, 0.0, 1.0}, 8.0 * kRounding);
    const Picture unequal = drawn(square({1e-3f, 0.0f, 1e-3f}, {-10.0f, 0.0f, 10.0f})).at("normal");
    const Picture equal = drawn(square(glm::normalize(glm::vec3(1, 0, 1)), glm::normalize(glm::vec3(-1, 0, 1)))).at("normal");
    require_texels(unequal, [&](int x, int y, int c) { return equal.at(x, y, c); }, 16.0 * kRounding);
}
