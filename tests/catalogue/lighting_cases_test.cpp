// Hard surfaces and lamps, as they arrive in a stored picture.
#include <cmath>

#include "support/catch.hpp"
#include "support/pass_runner.hpp"

using namespace passgraph;
using namespace passgraph::test;

namespace {

Scene lit_by(glm::vec3 color)
{
    Scene scene;
    scene.materials.push_back({});
    Light sun;
    sun.color = color;
    sun.direction = {0.0f, 0.0f, -1.0f};
    scene.lights = {sun};
    return scene;
}

/// A surface two metres in front of the viewer, facing it, of one albedo and one matter (specular, roughness, metallic).
Picture lit(const Scene& scene, std::initializer_list<float> albedo, std::initializer_list<float> matter)
{
    constexpr Extent kOne{1, 1};
    return run_for_output({.pass = "pbr",
                           .inputs = {{"albedo", constant(kOne, albedo)},
                                      {"material", constant(kOne, matter)},
                                      {"normal", constant(kOne, {0.0f, 0.0f, 1.0f})},
                                      {"position", constant(kOne, {0.0f, 0.0f, -2.0f})},
                                      {"emissive", constant(kOne, {0.0f, 0.0f, 0.0f})}},
                           .cubes = {{"sky", std::array<Picture, 6>{constant({4, 4}, {0, 0, 0}), constant({4, 4}, {0, 0, 0}),
                                                                    constant({4, 4}, {0, 0, 0}), constant({4, 4}, {0, 0, 0}),
                                                                    constant({4, 4}, {0, 0, 0}), constant({4, 4}, {0, 0, 0})}}},
                           .scene = &scene});
}

} // namespace

TEST_CASE("a metal of no color reflects nothing", "[catalogue][lighting]")
{
    // Head on, Schlick's edge is 0 and the metal's reflectance its albedo: black, exactly.
    for (const float roughness : {0.0f, 0.045f, 0.5f, 1.0f}) {
        const Picture picture = lit(lit_by(glm::vec3(10.0f)), {0.0f, 0.0f, 0.0f}, {0.5f, roughness, 1.0f});
        for (int c = 0; c < 3; ++c)
            CHECK(picture.at(0, 0, c) == 0.0f);
    }
}

TEST_CASE("a lamp of a million on a mirror is cut off at the largest half, not stored as infinity", "[catalogue][lighting]")
{
    // The highlight's peak is 1 / (4 pi alpha^2) = 19 406 at roughness 0.045; a million times that leaves halves.
    const Picture picture = lit(lit_by(glm::vec3(1e6f)), {1.0f, 1.0f, 1.0f}, {0.5f, 0.05f, 1.0f});
    for (int c = 0; c < 3; ++c)
        CHECK(picture.at(0, 0, c) == 65504.0f);
}
