// What a scene calls for: bounds that hold, against sums and formulas in double.
#include <cmath>
#include <numbers>
#include <random>

#include <passgraph/scene/facts.hpp>

#include "support/catch.hpp"

using namespace passgraph;

namespace {

/// One triangle in the plane z = 0, of side 2.
Scene triangle_scene()
{
    Scene scene;
    scene.materials.resize(1);
    Mesh mesh;
    for (const glm::vec3 place : {glm::vec3(-1, -1, 0), glm::vec3(1, -1, 0), glm::vec3(0, 1, 0)})
        mesh.vertices.push_back({place, {0, 0, 1}, {0, 0}});
    mesh.indices = {0, 1, 2};
    scene.meshes.push_back(mesh);
    scene.elements.resize(1);
    scene.camera.position = {0, 0, 5};
    return scene;
}

Light lamp(Light::Kind kind, glm::dvec3 place, float radius)
{
    Light light;
    light.kind = kind;
    light.position = place;
    light.radius = radius;
    return light;
}

} // namespace

TEST_CASE("lamps count by kind where they reach a surface", "[scene][facts]")
{
    Scene scene = triangle_scene();
    scene.lights = {lamp(Light::Kind::directional, {}, 0.0f), lamp(Light::Kind::point, {0, 0, 3}, 3.1f),
                    lamp(Light::Kind::point, {0, 0, 9}, 3.0f), lamp(Light::Kind::point, {0, 0, 1}, 0.0f),
                    lamp(Light::Kind::spot, {0, 0, 2}, 5.0f), lamp(Light::Kind::spot, {0, 0, 2}, 5.0f)};
    scene.lights.back().color = glm::vec3(0.0f);
    Facts facts = facts_of(scene);
    CHECK(facts.directional_lights == 1.0);
    CHECK(facts.point_lights == 1.0);
    CHECK(facts.spot_lights == 1.0);
    CHECK(facts.lights() == 3.0);
    CHECK(facts.surfaces == 1.0);
    scene.elements.clear(); // nothing to light
    facts = facts_of(scene);
    CHECK(facts.point_lights + facts.spot_lights + facts.irradiance + facts.surfaces == 0.0);
}

TEST_CASE("a lamp behind the camera that ends there reaches surfaces only in front of it", "[scene][facts]")
{
    Scene scene = triangle_scene();
    scene.elements.resize(2);
    scene.elements[1].world_from_model[3] = glm::dvec4(0, 0, 20, 1); // behind the camera
    scene.lights = {lamp(Light::Kind::point, {0, 0, 19}, 4.0f), lamp(Light::Kind::point, {0, 0, 1}, 4.0f),
                    lamp(Light::Kind::point, {0, 400, 0}, 4.0f), lamp(Light::Kind::directional, {}, 0.0f)};
    const auto reaches = lamp_reaches(scene);
    CHECK((reaches[0].to_surface && !reaches[0].to_view));
    CHECK((reaches[1].to_surface && reaches[1].to_view));
    CHECK((reaches[2].is_on && !reaches[2].to_surface));
    CHECK(reaches[3].to_view);
}

TEST_CASE("materials are bounded by factors and textures, those in use alone", "[scene][facts]")
{
    Scene scene = triangle_scene();
    scene.materials.resize(2);
    scene.materials[1].emissive = glm::vec3(9.0f); // nobody wears it
    scene.materials[0].metallic = 0.0f;
    scene.materials[0].roughness = 1.0f;
    Facts facts = facts_of(scene);
    CHECK(facts.metal == 0.0);
    CHECK(facts.emission == 0.0);
    CHECK(facts.sky == 0.0);
    Texture texture;
    texture.extent = {2, 1};
    texture.rgba = {51, 255, 102, 255, 0, 128, 0, 255};
    scene.textures.push_back(texture);
    scene.materials[0].metallic = 0.5f;
    scene.materials[0].metallic_roughness_texture = 0;
    scene.materials[0].emissive = {2.0f, 0.0f, 0.0f};
    scene.materials[0].emissive_texture = 0;
    facts = facts_of(scene);
    CHECK(facts.metal >= 0.2);
    CHECK(facts.metal < 0.21);
    CHECK(facts.emission >= 0.4); // 2 * 51 / 255; sRGB makes it less
    CHECK(facts.emission < 0.41);
    for (Picture& face : scene.sky.faces)
        face = Picture({1, 1}, 3);
    scene.sky.faces[3].texels[1] = 7.0f;
    CHECK(facts_of(scene).sky >= 7.0);
    CHECK(facts_of(scene).sky < 7.02);
}

// f n.l of GGX and Beckmann with Smith's masking, F = 1, over all directions: Walter et al. 2007, eq. 25, 33, 34; Heitz 2014, eq. 72.
TEST_CASE("no highlight is brighter than its bound", "[scene][facts]")
{
    using std::numbers::pi;
    for (const double roughness : {0.045, 0.1, 0.3, 0.6, 0.85, 1.0}) {
        Scene scene = triangle_scene();
        scene.materials[0].roughness = static_cast<float>(roughness);
        const double bound = facts_of(scene).highlight;
        const double a = roughness * roughness;
        double most = 0.0;
        const auto look = [&](double l_angle, double v_angle, double turn) {
            const glm::dvec3 l(std::sin(l_angle), 0.0, std::cos(l_angle));
            const glm::dvec3 v(std::sin(v_angle) * std::cos(turn), std::sin(v_angle) * std::sin(turn), std::cos(v_angle));
            const double h = glm::normalize(l + v).z;
            const double tangent = (1.0 - h * h) / (h * h);
            const auto lambda = [&](double cosine, bool is_ggx) {
                const double t = std::sqrt(1.0 - cosine * cosine) / cosine;
                if (is_ggx)
                    return 0.5 * (std::sqrt(1.0 + a * a * t * t) - 1.0);
                const double s = 1.0 / (a * t);
                return 0.5 * (std::erf(s) - 1.0 + std::exp(-s * s) / (s * std::sqrt(pi)));
            };
            for (const bool is_ggx : {true, false}) {
                const double density = is_ggx ? a * a / (pi * std::pow(h * h * (a * a - 1.0) + 1.0, 2.0))
                                              : std::exp(-tangent / (a * a)) / (pi * a * a * h * h * h * h);
                most = std::max(most, density / (1.0 + lambda(l.z, is_ggx) + lambda(v.z, is_ggx)) / (4.0 * v.z));
            }
        };
        for (int i = 0; i < 60; ++i)
            for (int k = 0; k < 60; ++k)
                for (const double turn : {pi, 0.97 * pi, 0.8 * pi, 0.5 * pi})
                    look(1.5707 * (i + 0.5) / 60.0, 1.5707 * (k + 0.5) / 60.0, turn);
        look(1.5706, 1.5706, pi);
        CAPTURE(roughness, most);
        CHECK(bound >= most);
        CHECK(bound < 20.0 * most); // and says something
    }
}

TEST_CASE("no place receives more than the irradiance bound", "[scene][facts]")
{
    std::mt19937 random(2);
    const auto between = [&](double low, double high) { return low + (high - low) * static_cast<double>(random() % 4096) / 4096.0; };
    for (int round = 0; round < 50; ++round) {
        Scene scene = triangle_scene();
        for (int i = 0; i < 5; ++i) {
            scene.lights.push_back(lamp(static_cast<Light::Kind>(random() % 3), {between(-4, 4), between(-4, 4), between(-4, 4)}, 6.0f));
            scene.lights.back().color = glm::vec3(static_cast<float>(between(0, 5)));
        }
        const double bound = facts_of(scene).irradiance;
        for (int sample = 0; sample < 200; ++sample) {
            const glm::dvec3 place(between(-1, 1), between(-1, 1), 0.0);
            double sum = 0.0;
            for (const Light& light : scene.lights) {
                const double squared = std::max(glm::dot(light.position - place, light.position - place), 1e-4);
                const double window = std::max(1.0 - std::pow(squared / 36.0, 2.0), 0.0);
                sum += static_cast<double>(light.color.x) * (light.kind == Light::Kind::directional ? 1.0 : window * window / squared);
            }
            CHECK(sum <= bound * (1.0 + 1e-6));
        }
    }
}
