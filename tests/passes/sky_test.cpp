// The sky: where nothing was drawn, and nowhere else.
#include <array>

#include <passgraph/scene/scene.hpp>

#include "passes/expected.hpp"
#include "support/catch.hpp"
#include "support/pass_runner.hpp"

using namespace passgraph;
using namespace passgraph::test;

namespace {

std::array<Picture, 6> uniform_sky()
{
    std::array<Picture, 6> faces;
    faces.fill(constant({4, 4}, {0.25f, 0.5f, 2.0f}));
    return faces;
}

Picture behind(const Picture& image, const Picture& depth, const std::string& intensity)
{
    const Scene scene; // a camera at the origin that looks along -Z
    return run_for_output({.pass = "sky", .inputs = {{"image", image}, {"depth", depth}}, .cubes = {{"sky", uniform_sky()}},
                           .settings = {{"intensity", intensity}}, .scene = &scene});
}

} // namespace

TEST_CASE("the sky is shown exactly where depth is 0", "[passes][sky]")
{
    unsigned seed = 110;
    for (const Extent extent : kExtents) {
        const Picture image = noise(extent, 3, 0.0f, 4.0f, seed++);
        Picture depth(extent, 1);
        for (size_t i = 0; i < depth.texels.size(); ++i)
            depth.texels[i] = i % 3 == 0 ? 0.0f : i % 3 == 1 ? 1e-7f : 1.0f;
        const auto expected = [&](int x, int y, int c) {
            return depth.at(x, y) > 0.0f ? double(image.at(x, y, c)) : std::array{0.5, 1.0, 4.0}[static_cast<size_t>(c)];
        };
        // Surfaces pass unchanged; the filter's weights over equal texels sum to 1 within 6 roundings.
        require_texels(behind(image, depth, "2"), expected, [&](int x, int y, int) { return depth.at(x, y) > 0.0f ? 0.0 : 24.0 * kRounding; });
    }
}

TEST_CASE("a sky of intensity 0 is black", "[passes][sky]")
{
    const Extent extent{5, 3};
    const Picture got = behind(constant(extent, {1.0f, 1.0f, 1.0f}), constant(extent, {0.0f}), "0");
    require_same(got, constant(extent, {0.0f, 0.0f, 0.0f}));
}

TEST_CASE("a picture full of surfaces shows no sky", "[passes][sky][identity]")
{
    const Picture image = noise({17, 13}, 3, 0.0f, 4.0f, 115);
    require_same(behind(image, constant({17, 13}, {0.5f}), "1"), image);
}
