// How light thins out with distance: the inverse square, bounded near the lamp and exactly 0 at its radius.
#include <algorithm>
#include <cmath>
#include <vector>

#include "passes/expected.hpp"
#include "support/catch.hpp"
#include "support/pass_runner.hpp"

using namespace passgraph::test;

namespace {

std::vector<std::vector<float>> attenuation(const std::vector<std::vector<float>>& radius_and_distance)
{
    return evaluate("windowed_inverse_square(d * d, radius)", {"attenuation.glsl"}, {"radius", "d"}, radius_and_distance);
}

} // namespace

TEST_CASE("attenuation is the windowed inverse square of the table", "[passes][attenuation]")
{
    const Table table = read_table("attenuation.csv");
    const size_t radius = table.column("radius");
    const size_t distance = table.column("distance");
    const size_t expected = table.column("windowed_max_d2_1e-4");
    std::vector<std::vector<float>> rows;
    for (const auto& row : table.rows)
        rows.push_back({static_cast<float>(row[radius]), static_cast<float>(row[distance])});
    const auto got = attenuation(rows);
    REQUIRE(got.size() == rows.size());
    for (size_t i = 0; i < rows.size(); ++i) {
        const auto& row = table.rows[i];
        CAPTURE(row[radius], row[distance], got[i][0], row[expected]);
        // The window 1 - (d/r)^4 carries 4 input, 2 x (1 + 1) and 2 more roundings, absolutely, as it cancels near r;
        // squared, and divided by max(d^2, 1e-4). Three roundings and d's two weigh on the quotient itself.
        const double per_distance = 1.0 / std::max(row[distance] * row[distance], 1e-4);
        const double window_error = 10.0 * kRounding;
        const double window = std::sqrt(row[expected] / per_distance);
        CHECK(std::abs(got[i][0] - row[expected]) <=
              (2.0 * window * window_error + window_error * window_error) * per_distance + 7.0 * kRounding * row[expected]);
    }
}

TEST_CASE("attenuation is exactly 0 at the radius and beyond, so that a lamp may be skipped there", "[passes][attenuation]")
{
    std::vector<std::vector<float>> rows;
    for (const float radius : {0.1f, 1.0f, 3.0f, 7.7f, 250.0f, 1e4f})
        for (const float distance : {radius, std::nextafter(radius, INFINITY), 1.001f * radius, 2.0f * radius, 1e15f})
            rows.push_back({radius, distance});
    for (const auto& value : attenuation(rows))
        CHECK(value[0] == 0.0f);
}

TEST_CASE("attenuation stays finite at the lamp, where the original's 5000 / d^2 has no bound", "[passes][attenuation][defect 7]")
{
    const auto got = attenuation({{25.0f, 0.0f}, {25.0f, 1e-30f}, {25.0f, 0.005f}, {1e-3f, 0.0f}});
    for (const auto& value : got)
        CHECK(value[0] == Approx(10000.0).epsilon(1e-6));
}

TEST_CASE("a lamp of radius 0 is off", "[passes][attenuation]")
{
    for (const auto& value : attenuation({{0.0f, 0.0f}, {0.0f, 1e-20f}, {0.0f, 1.0f}, {0.0f, 1e6f}}))
        CHECK(value[0] == 0.0f);
}

TEST_CASE("attenuation never grows with distance", "[passes][attenuation]")
{
    std::vector<std::vector<float>> rows;
    for (int i = 0; i <= 2000; ++i)
        rows.push_back({5.0f, static_cast<float>(i) * 0.003f});
    const auto got = attenuation(rows);
    for (size_t i = 1; i < got.size(); ++i)
        CHECK(got[i][0] <= got[i - 1][0]);
}
