// How light thins out with distance: the inverse square, bounded near the lamp and exactly 0 at its radius.
#include <algorithm>
#include <cmath>
#include <vector>

#include "gl/view_space.hpp"
#include "passes/expected.hpp"
#include "support/catch.hpp"
#include "support/pass_runner.hpp"

using namespace passgraph::test;
using passgraph::gl::per_radius_squared;

namespace {

std::vector<std::vector<float>> attenuation(const std::vector<std::vector<float>>& radius_and_distance)
{
    std::vector<std::vector<float>> rows;
    for (const auto& row : radius_and_distance)
        rows.push_back({per_radius_squared(row[0]), row[1]});
    return evaluate("windowed_inverse_square(d * d, per_radius_squared)", {"attenuation.glsl"}, {"per_radius_squared", "d"}, rows);
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
        // The window 1 - (d/r)^4 carries 4 input, 2 x (1 + 1), 2 more roundings and 1 / r^2's four units twice, absolutely, as it cancels near r;
        // squared, and divided by max(d^2, 1e-4). Three roundings and d's two weigh on the quotient itself.
        const double per_distance = 1.0 / std::max(row[distance] * row[distance], 1e-4);
        const double window_error = 20.0 * kRounding;
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

TEST_CASE("a cone's share is 0 outside, 1 inside, and steps where its angles are equal", "[passes][attenuation]")
{
    const auto share = [](float inner, float outer, const std::vector<double>& degrees) {
        passgraph::Light light;
        light.kind = passgraph::Light::Kind::spot;
        light.direction = {0.0f, 0.0f, -1.0f};
        light.inner_angle = glm::radians(inner);
        light.outer_angle = glm::radians(outer);
        const glm::vec4 cone = passgraph::gl::cone_texel(light, glm::dmat3(1.0));
        std::vector<std::vector<float>> rows;
        for (const double angle : degrees) {
            const double radians = angle * 3.14159265358979324 / 180.0;
            rows.push_back({static_cast<float>(std::sin(radians)), static_cast<float>(std::cos(radians)), cone.x, cone.z, cone.w});
        }
        std::vector<float> shares; // l points to the light, against its axis
        for (const auto& value : evaluate("cone_share(offset - (lx * ax + lz * az))", {"attenuation.glsl"}, {"lx", "lz", "ax", "az", "offset"}, rows))
            shares.push_back(value[0]);
        return shares;
    };
    const auto soft = share(20.0f, 40.0f, {0, 19, 25, 30, 35, 41, 90, 180});
    CHECK(soft[0] == 1.0f);
    CHECK(soft[1] == 1.0f);
    CHECK((soft[1] > soft[2] && soft[2] > soft[3] && soft[3] > soft[4] && soft[4] > 0.0f));
    const double ramp = (std::cos(0.523598776) - std::cos(0.698131701)) / (std::cos(0.34906585) - std::cos(0.698131701));
    CHECK(soft[3] == Approx(ramp * ramp).epsilon(1e-5));
    for (size_t i = 5; i < 8; ++i)
        CHECK(soft[i] == 0.0f);
    // At 30 degrees an edge of 1e-4 in the cosine is 0.012 degrees wide.
    CHECK(share(30.0f, 30.0f, {0, 29.98, 30.01, 90}) == std::vector<float>{1.0f, 1.0f, 0.0f, 0.0f});
    CHECK(share(180.0f, 180.0f, {0, 90, 179}) == std::vector<float>{1.0f, 1.0f, 1.0f});
    CHECK(share(0.0f, 180.0f, {0})[0] == Approx(1.0f).epsilon(1e-6));
}
