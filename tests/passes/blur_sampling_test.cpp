// Linear pairs: half the reads, the same blur.
#include <string>

#include "passes/expected.hpp"
#include "support/catch.hpp"
#include "support/pass_runner.hpp"

using namespace passgraph;
using namespace passgraph::test;

namespace {

Picture blurred(const Picture& image, const std::string& taps, const std::string& sigma, const std::string& sampling)
{
    return run_for_output({.pass = "blur_direction", .inputs = {{"image", image}}, .settings = {{"taps", taps}, {"sigma", sigma}, {"sampling", sampling}}});
}

} // namespace

TEST_CASE("linear pairs give what nearest taps give", "[passes][blur]")
{
    unsigned seed = 90;
    for (const char* taps : {"5", "9", "13", "25", "learnopengl5"})
        for (const char* sigma : {"0", "0.3", "2", "6"})
            for (const Extent extent : kExtents) {
                const Picture image = noise(extent, 3, 0.0f, 1.0f, seed++);
                const Picture nearest = blurred(image, taps, sigma, "nearest_taps");
                CAPTURE(taps, sigma, extent.width, extent.height);
                // A place between two texels is rounded three times, at uv of 1: 3 * 2^-24 of the picture's width, at most 25 + 17
                // texels from its middle; a step of 1 between neighbours turns that into as much of a value, per pair of weight 1.
                // The sums add what nearest taps' own test allows.
                const double place = 3.0 * kRounding * (extent.width + 25.0);
                require_texels(blurred(image, taps, sigma, "linear_pairs"), [&](int x, int y, int c) { return nearest.at(x, y, c); }, place + 64.0 * kRounding);
            }
}
