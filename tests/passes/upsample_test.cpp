// Doubling: bilinear between the centers, constant beyond the outermost.
#include "passes/expected.hpp"
#include "support/catch.hpp"
#include "support/pass_runner.hpp"

using namespace passgraph;
using namespace passgraph::test;

namespace {

Picture doubled(const Picture& image)
{
    return run_for_output({.pass = "upsample", .inputs = {{"image", image}}});
}

} // namespace

TEST_CASE("a doubled picture is the bilinear one", "[passes][resample]")
{
    unsigned seed = 40;
    for (const Extent extent : kExtents) {
        const Picture image = noise(extent, 3, 0.0f, 4.0f, seed++);
        const Picture got = doubled(image);
        REQUIRE(got.extent == Extent{2 * extent.width, 2 * extent.height});
        // As for halving: 4 roundings of a place among 17 texels, times a step of 4; 6 roundings of the value.
        require_texels(got, [&](int x, int y, int c) { return bilinear(image, (x + 0.5) / 2.0, (y + 0.5) / 2.0, c); },
                       (4.0 * 17.0 + 6.0) * kRounding * 4.0);
    }
}

TEST_CASE("a constant picture is doubled to the same constant", "[passes][resample][identity]")
{
    const Picture got = doubled(constant({17, 13}, {0.7f, 1.5f, 3.0f}));
    require_texels(got, [](int, int, int c) { return std::array{0.7f, 1.5f, 3.0f}[static_cast<size_t>(c)]; }, 6.0 * kRounding * 3.0);
}

TEST_CASE("a slope stays a slope", "[passes][resample][identity]")
{
    Picture image({16, 1}, 3);
    for (int x = 0; x < 16; ++x)
        for (int c = 0; c < 3; ++c)
            image.at(x, 0, c) = static_cast<float>(x) + 0.5f;
    const Picture got = doubled(image);
    for (int x = 1; x < 31; ++x)
        CHECK(got.at(x, 0, 0) == Approx((x + 0.5) / 2.0).margin((4.0 * 16.0 + 6.0 * 16.0) * kRounding));
}
