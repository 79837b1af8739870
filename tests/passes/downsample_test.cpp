// Halving: the mean of four texels, at odd sizes too without a shift.
#include "passes/expected.hpp"
#include "support/catch.hpp"
#include "support/pass_runner.hpp"

using namespace passgraph;
using namespace passgraph::test;

namespace {

Picture halved(const Picture& image)
{
    return run_for_output({.pass = "downsample", .inputs = {{"image", image}}});
}

/// The sampler's place is uv times the size: 4 roundings of up to `texels` texels, times the largest step between
/// neighbours; the filter's three interpolations add 6 roundings of the value.
double tolerance(int texels, double brightest)
{
    return (4.0 * texels + 6.0) * kRounding * brightest;
}

} // namespace

TEST_CASE("a halved picture of even size holds the means of four texels", "[passes][resample]")
{
    const Picture image = noise({64, 26}, 3, 0.0f, 4.0f, 30);
    const Picture got = halved(image);
    REQUIRE(got.extent == Extent{32, 13});
    const auto mean = [&](int x, int y, int c) {
        return 0.25 * (double(image.at(2 * x, 2 * y, c)) + image.at(2 * x + 1, 2 * y, c) + image.at(2 * x, 2 * y + 1, c) + image.at(2 * x + 1, 2 * y + 1, c));
    };
    require_texels(got, mean, tolerance(64, 4.0));
}

TEST_CASE("a halved picture of odd size is sampled at its centers", "[passes][resample]")
{
    unsigned seed = 31;
    for (const Extent extent : kExtents) {
        const Picture image = noise(extent, 3, 0.0f, 4.0f, seed++);
        const Picture got = halved(image);
        REQUIRE(got.extent == Extent{(extent.width + 1) / 2, (extent.height + 1) / 2});
        const auto expected = [&](int x, int y, int c) {
            return bilinear(image, (x + 0.5) * extent.width / got.extent.width, (y + 0.5) * extent.height / got.extent.height, c);
        };
        require_texels(got, expected, tolerance(17, 4.0));
    }
}

TEST_CASE("a constant picture is halved to the same constant", "[passes][resample][identity]")
{
    for (const Extent extent : kExtents) {
        const Picture got = halved(constant(extent, {0.7f, 1.5f, 3.0f}));
        require_texels(got, [](int, int, int c) { return std::array{0.7f, 1.5f, 3.0f}[static_cast<size_t>(c)]; }, 6.0 * kRounding * 3.0);
    }
}

TEST_CASE("one texel is halved to itself", "[passes][resample][identity]")
{
    const Picture image = constant({1, 1}, {0.25f, 1.5f, 3.0f});
    require_same(halved(image), image);
}

TEST_CASE("a mirror image is halved to a mirror image", "[passes][resample]")
{
    const Picture image = noise({17, 13}, 3, 0.0f, 4.0f, 36);
    const Picture straight = mirrored(halved(image));
    require_texels(halved(mirrored(image)), [&](int x, int y, int c) { return straight.at(x, y, c); }, 2.0 * tolerance(17, 4.0));
}

TEST_CASE("a picture scaled to a fourth or an eighth holds the means of all texels that each new one covers", "[passes][resample]")
{
    for (const int factor : {4, 8}) {
        CAPTURE(factor);
        const Picture image = noise({64, 24}, 3, 0.0f, 4.0f, 38);
        const Picture got = run_for_output({.pass = "downsample", .inputs = {{"image", image}}, .scale = Ratio{1, factor}});
        REQUIRE(got.extent == Extent{64 / factor, 24 / factor});
        const auto mean = [&](int x, int y, int c) {
            double sum = 0.0;
            for (int j = 0; j < factor; ++j)
                for (int i = 0; i < factor; ++i)
                    sum += image.at(factor * x + i, factor * y + j, c);
            return sum / (factor * factor);
        };
        // The sum's own roundings come on top: one for each four texels.
        require_texels(got, mean, tolerance(64, 4.0) + factor * factor / 4.0 * kRounding * 4.0);
    }
}
