// The composite blur: two directions, one Gaussian.
#include <cmath>
#include <string>

#include "passes/expected.hpp"
#include "support/catch.hpp"
#include "support/pass_runner.hpp"

using namespace passgraph;
using namespace passgraph::test;

namespace {

Picture blurred(const Picture& image, const std::string& sigma, const std::string& taps = "25")
{
    return run_for_output({.pass = "gaussian_blur", .inputs = {{"image", image}}, .settings = {{"sigma", sigma}, {"taps", taps}}});
}

Picture along(const Picture& image, const std::string& direction, const std::string& sigma)
{
    return run_for_output({.pass = "blur_direction", .inputs = {{"image", image}}, .settings = {{"direction", direction}, {"sigma", sigma}, {"taps", "25"}}});
}

/// Between the directions the rows are stored as radiance is by default, in binary16: by truncation on some drivers, so
/// 2^-10 relative and 2^-24 at its bottom, of each of a sum of positive terms, hence of the sum.
double stored_half(double value) { return value / 1024.0 + 1.0 / 16777216.0; }

} // namespace

TEST_CASE("gaussian blur is a blur along rows, then along columns", "[passes][blur]")
{
    unsigned seed = 20;
    for (const Extent extent : kExtents) {
        const Picture image = noise(extent, 3, 0.0f, 4.0f, seed++);
        const Picture expected = along(along(image, "horizontal", "1.7"), "vertical", "1.7");
        require_texels(blurred(image, "1.7"), [&](int x, int y, int c) { return expected.at(x, y, c); },
                       [&](int x, int y, int c) { return stored_half(expected.at(x, y, c)) + 64.0 * kRounding * 4.0; });
    }
}

TEST_CASE("one bright texel spreads to a round Gaussian and loses nothing", "[passes][blur]")
{
    Picture image({41, 41}, 3);
    image.at(20, 20, 1) = 1.0f;
    const Picture got = blurred(image, "2");
    double sum = 0.0;
    for (const float value : got.texels)
        sum += value;
    // 12 texels are 6 sigma: what is cut off, 2e-9, was put back by the normalisation. Each direction carries the 64
    // roundings derived in the test of one.
    CHECK(sum == Approx(1.0).margin(stored_half(1.0) + 128.0 * kRounding));
    const auto expected = [](int x, int y, int c) {
        const double squared = (x - 20.0) * (x - 20.0) + (y - 20.0) * (y - 20.0);
        return c == 1 ? std::exp(-squared / 8.0) / (8.0 * 3.14159265358979324) : 0.0;
    };
    // Beyond 12 texels a Gaussian of sigma 2 is below 1e-8 of its peak.
    require_texels(got, expected, [&](int x, int y, int c) { return stored_half(expected(x, y, c)) + 128.0 * kRounding * 0.04 + 1e-9; });
}

TEST_CASE("blur of 1.5, then of 2, is blur of 2.5, because variances add", "[passes][blur]")
{
    Picture image({51, 51}, 3);
    image.at(25, 25, 0) = 1.0f;
    const Picture twice = blurred(blurred(image, "1.5"), "2");
    const Picture once = blurred(image, "2.5");
    // Sampled Gaussians add like the functions do, within exp(-2 pi^2 1.5^2) = 1e-19. 25 taps cut a sigma of 2.5 off at
    // 12 texels: 1.0e-5 of its center's weight, 0.16, times the other direction's 0.16. Three binary16 stores differ.
    const auto expected = [&](int x, int y, int c) { return double(once.at(x, y, c)); };
    require_texels(twice, expected, [&](int x, int y, int c) {
        return 3.0 * stored_half(expected(x, y, c)) + 0.16 * 0.16 * 1.0e-5 + 256.0 * kRounding * 0.026;
    });
}

TEST_CASE("gaussian blur of sigma 0 is its input", "[passes][blur][identity]")
{
    Picture image = noise({17, 13}, 3, 0.0f, 4.0f, 21);
    for (float& value : image.texels)
        value = std::floor(value * 256.0f) / 256.0f; // values that binary16 holds
    for (const char* taps : {"5", "13", "learnopengl5"})
        require_same(blurred(image, "0", taps), image);
}

TEST_CASE("gaussian blur does not brighten a constant picture", "[passes][blur][defect 5]")
{
    const Picture grey = constant({17, 13}, {0.7f, 1.5f, 3.0f});
    require_texels(blurred(grey, "1.7", "learnopengl5"), [&](int x, int y, int c) { return grey.at(x, y, c); },
                   [&](int x, int y, int c) { return stored_half(grey.at(x, y, c)) + 128.0 * kRounding * 3.0; });
}
