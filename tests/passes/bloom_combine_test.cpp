// Bloom added to a scene: a sum, of equal or of different sizes.
#include "passes/expected.hpp"
#include "support/catch.hpp"
#include "support/pass_runner.hpp"

using namespace passgraph;
using namespace passgraph::test;

namespace {

Picture combined(const Picture& scene, const Picture& bloom, const std::string& strength)
{
    return run_for_output({.pass = "bloom_combine", .inputs = {{"scene", scene}, {"bloom", bloom}}, .settings = {{"strength", strength}}});
}

/// 4 roundings of the sampler's place, times a step of up to 4; 6 of the filter, 2 of the product and 1 of the sum.
constexpr double kTolerance = (4.0 * 17.0 * 4.0 + 9.0 * 12.0) * kRounding;

} // namespace

TEST_CASE("bloom of the scene's size is added texel by texel", "[passes][bloom]")
{
    unsigned seed = 50;
    for (const Extent extent : kExtents) {
        const Picture scene = noise(extent, 3, 0.0f, 4.0f, seed++);
        const Picture bloom = noise(extent, 3, 0.0f, 4.0f, seed++);
        const Picture got = combined(scene, bloom, "2");
        REQUIRE(got.extent == extent);
        require_texels(got, [&](int x, int y, int c) { return double(scene.at(x, y, c)) + 2.0 * bloom.at(x, y, c); }, 2.0 * kTolerance);
    }
}

TEST_CASE("bloom of half the size is added smoothly, at the scene's size", "[passes][bloom]")
{
    const Picture scene = noise({17, 13}, 3, 0.0f, 4.0f, 60);
    const Picture bloom = noise({9, 7}, 3, 0.0f, 4.0f, 61);
    const Picture got = combined(scene, bloom, "1");
    REQUIRE(got.extent == Extent{17, 13});
    const auto expected = [&](int x, int y, int c) {
        return scene.at(x, y, c) + bilinear(bloom, (x + 0.5) * 9.0 / 17.0, (y + 0.5) * 7.0 / 13.0, c);
    };
    require_texels(got, expected, kTolerance);
}

TEST_CASE("bloom of strength 0 leaves the scene alone", "[passes][bloom][identity]")
{
    const Picture scene = noise({17, 13}, 3, 0.0f, 4.0f, 62);
    require_same(combined(scene, noise({17, 13}, 3, 0.0f, 4.0f, 63), "0"), scene);
}

TEST_CASE("black bloom leaves the scene alone", "[passes][bloom][identity]")
{
    const Picture scene = noise({17, 13}, 3, 0.0f, 4.0f, 64);
    require_same(combined(scene, constant({9, 7}, {0.0f, 0.0f, 0.0f}), "3"), scene);
}
