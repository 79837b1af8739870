// The Gaussian in double: its weights against a table, its blur against what a Gaussian is.
#include <cmath>
#include <numbers>
#include <numeric>

#include "support/catch.hpp"
#include "support/pass_runner.hpp"
#include "tool/accuracy/reference/reference.hpp"

using namespace passgraph;

TEST_CASE("a Gaussian's weights are the table's densities, scaled to a sum of 1", "[reference]")
{
    const test::Table table = test::read_table("gauss_reference.csv");
    for (const std::vector<double>& row : table.rows) {
        const double sigma = row[table.column("sigma")];
        const auto k = static_cast<size_t>(row[table.column("k")]);
        const std::vector<double> weights = reference::gaussian_weights(sigma);
        // Poisson's summation: densities at all whole texels sum to 1 + 2 sum of exp(-2 (pi n sigma)^2).
        double total = 1.0;
        for (int n = 1; n <= 4; ++n)
            total += 2.0 * std::exp(-2.0 * std::pow(std::numbers::pi * n * sigma, 2.0));
        CAPTURE(sigma, k);
        if (k < weights.size())
            CHECK(weights[k] == Approx(row[table.column("point_density")] / total).epsilon(1e-12).margin(1e-300));
        CHECK(2.0 * std::accumulate(weights.begin(), weights.end(), 0.0) - weights[0] == Approx(1.0).epsilon(1e-14));
    }
}

TEST_CASE("a blur of one texel has the asked variance along both axes, and its energy", "[reference]")
{
    constexpr int kSide = 65;
    std::vector<double> image(kSide * kSide, 0.0);
    image[32 * kSide + 32] = 5.0;
    const std::vector<double> blurred = reference::gaussian_blur(image, kSide, kSide, 1, 3.0);
    double mass = 0.0, across = 0.0, along = 0.0;
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            const double value = blurred[static_cast<size_t>(y * kSide + x)];
            mass += value;
            across += value * (x - 32) * (x - 32);
            along += value * (y - 32) * (y - 32);
        }
    // Sampled at whole texels a Gaussian of sigma 3 keeps its variance to 2 exp(-2 pi^2 9) = 1e-77; the reach of 27 is 9 sigma.
    CHECK(mass == Approx(5.0).epsilon(1e-13));
    CHECK(across / mass == Approx(9.0).epsilon(1e-12));
    CHECK(along / mass == Approx(9.0).epsilon(1e-12));
}

TEST_CASE("a blur by 3 and then by 4 is a blur by 5, away from the edges", "[reference]")
{
    constexpr int kWidth = 200;
    std::vector<double> image(kWidth, 0.0);
    image[100] = 1.0;
    image[110] = 2.0;
    const auto blur = [&](const std::vector<double>& from, double sigma) { return reference::gaussian_blur(from, kWidth, 1, 1, sigma); };
    const std::vector<double> twice = blur(blur(image, 3.0), 4.0);
    const std::vector<double> once = blur(image, 5.0);
    for (int x = 60; x < 150; ++x)
        CHECK(twice[static_cast<size_t>(x)] == Approx(once[static_cast<size_t>(x)]).margin(1e-14));
}

TEST_CASE("the edge texel stands for those outside, channel by channel", "[reference]")
{
    const std::vector<double> even(7 * 3 * 2, 0.25);
    for (const double value : reference::gaussian_blur(even, 7, 3, 2, 2.0))
        CHECK(value == Approx(0.25).epsilon(1e-14));
    std::vector<double> two = {1.0, 0.0, 0.0, 0.0}; // two texels of two channels
    const std::vector<double> blurred = reference::gaussian_blur(two, 2, 1, 2, 1.0);
    CHECK(blurred[0] + blurred[2] == Approx(1.0).epsilon(1e-14));
    CHECK(blurred[1] == 0.0);
    CHECK(blurred[0] > blurred[2]);
}
