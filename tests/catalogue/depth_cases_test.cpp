// Hard depths, cameras and triangles.
#include <cmath>
#include <limits>

#include "support/catch.hpp"
#include "support/pass_runner.hpp"

using namespace passgraph;
using namespace passgraph::test;

namespace {

Scene seen_from(float near_plane, float far_plane)
{
    Scene scene;
    scene.materials.push_back({});
    scene.camera.near_plane = near_plane;
    scene.camera.far_plane = far_plane;
    return scene;
}

Picture places(const Scene& scene, const std::vector<float>& depths)
{
    Picture depth({static_cast<int>(depths.size()), 1}, 1);
    depth.texels = depths;
    return run_for_output({.pass = "position_from_depth", .inputs = {{"depth", depth}}, .scene = &scene});
}

/// A scene of one triangle in front of the camera, with these corners.
Scene triangle(const std::array<glm::vec3, 3>& corners)
{
    Scene scene = seen_from(0.1f, 1000.0f);
    Mesh mesh;
    for (const glm::vec3& corner : corners)
        mesh.vertices.push_back({corner, {0.0f, 0.0f, 1.0f}, {0.0f, 0.0f}});
    mesh.indices = {0, 1, 2};
    scene.meshes.push_back(mesh);
    scene.materials.front().is_double_sided = true;
    scene.elements.push_back({});
    return scene;
}

/// Every value of every output is finite; returns how many pixels the triangle covers.
int covered(const Scene& scene)
{
    int count = 0;
    for (const auto& [name, picture] : run_pass({.pass = "gbuffer", .extent = {32, 24}, .scene = &scene})) {
        INFO(name);
        for (const float value : picture.texels)
            CHECK(std::isfinite(value));
        if (name == "depth")
            for (const float value : picture.texels)
                count += value > 0.0f ? 1 : 0;
    }
    return count;
}

} // namespace

TEST_CASE("a depth of 0, where nothing is, is the viewer's own place and not infinitely far", "[catalogue][depth]")
{
    const Picture place = places(seen_from(0.1f, 1000.0f), {0.0f, -0.0f});
    for (const float value : place.texels)
        CHECK(value == 0.0f);
}

TEST_CASE("a far plane ten million times as far as the near one costs no accuracy", "[catalogue][depth]")
{
    constexpr float kNear = 0.001f;
    constexpr float kFar = 10000.0f;
    std::vector<float> depths;
    std::vector<double> distances;
    for (double z = 0.0011; z < 9000.0; z *= 1.7) {
        const double n = static_cast<double>(kNear);
        const double f = static_cast<double>(kFar);
        depths.push_back(static_cast<float>(n * (f - z) / (z * (f - n)))); // reversed: 1 near, 0 far
        distances.push_back(z);
    }
    const Picture place = places(seen_from(kNear, kFar), depths);
    for (size_t i = 0; i < depths.size(); ++i) {
        const double z = -static_cast<double>(place.texels[i * 3 + 2]);
        // A depth's rounding of 2^-24 is relative to n / z beside the far plane's n / f: dz / z = 2^-24 (1 - z / f); five more
        // roundings make the way back.
        INFO("at " << distances[i] << " m");
        CHECK(std::abs(z / distances[i] - 1.0) <= 8.0 / 16777216.0);
    }
}

TEST_CASE("a triangle through the near plane is cut there, and one behind the viewer is not seen", "[catalogue][depth]")
{
    const int through = covered(triangle({{{-2.0f, -1.0f, -4.0f}, {2.0f, -1.0f, -4.0f}, {0.0f, 0.5f, 1.0f}}}));
    CHECK(through > 0);
    CHECK(covered(triangle({{{-2.0f, -1.0f, 4.0f}, {2.0f, -1.0f, 4.0f}, {0.0f, 2.0f, 5.0f}}})) == 0);
}

TEST_CASE("a triangle without area, or with a corner that is no place, leaves nothing that is not finite", "[catalogue][depth]")
{
    CHECK(covered(triangle({{{-1.0f, 0.0f, -2.0f}, {1.0f, 0.0f, -2.0f}, {0.5f, 0.0f, -2.0f}}})) == 0);
    CHECK(covered(triangle({{{-1.0f, -1.0f, -2.0f}, {-1.0f, -1.0f, -2.0f}, {1.0f, 1.0f, -2.0f}}})) == 0);
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()})
        covered(triangle({{{-1.0f, -1.0f, -2.0f}, {1.0f, -1.0f, -2.0f}, {0.0f, bad, -2.0f}}}));
}
