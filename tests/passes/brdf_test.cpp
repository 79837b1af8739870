// Microfacet terms against 50-digit tables, and the hard directions: edge-on, opposite, behind.
#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "passes/expected.hpp"
#include "support/catch.hpp"
#include "support/pass_runner.hpp"

using namespace passgraph::test;

namespace {

// Roundings in units of 2^-24, relative, all sums being of positive terms: D: alpha^2 3, bracket 3 + 4, twice in its square
// + 1, |h|^4 4, numerator 2, quotient 1 and llvmpipe's half ulp: 25.  V: alpha^2 3, root 4, products and sum 6: 14.
constexpr double kDistribution = 25.0 * kRounding;
constexpr double kVisibility = 14.0 * kRounding;
constexpr double kSpecular = kDistribution + 11.0 * kRounding + kVisibility + 2.0 * kRounding;

std::array<float, 3> direction(double x, double y, double z)
{
    const double length = std::sqrt(x * x + y * y + z * z);
    return {static_cast<float>(x / length), static_cast<float>(y / length), static_cast<float>(z / length)};
}

const std::string kDefaults = "Terms(0, 0, 0, 2, 1, 1)"; // the choices' first items, the ladders' last rungs
const std::vector<std::string> kDirections = {"vx", "vy", "vz", "lx", "ly", "lz", "roughness", "metallic"};
const std::string kReflected = "reflected(make_surface(vec3(0.9, 0.5, 0.1), vec3(0.5, roughness, metallic), vz, " + kDefaults + "), "
                               "vec3(0.0, 0.0, 1.0), vec3(vx, vy, vz), vec3(lx, ly, lz), " + kDefaults + ")";

std::vector<std::vector<float>> reflected(const std::vector<std::vector<float>>& rows)
{
    return evaluate(kReflected, {"brdf.glsl"}, kDirections, rows);
}

} // namespace

TEST_CASE("light and viewer may change places", "[passes][brdf]")
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> across(-1.0, 1.0), up(0.02, 1.0), rough(0.05, 1.0), metal(0.0, 1.0);
    std::vector<std::vector<float>> there, back;
    for (int i = 0; i < 500; ++i) {
        const auto v = direction(across(random), across(random), up(random));
        const auto l = direction(across(random), across(random), up(random));
        const float roughness = static_cast<float>(rough(random));
        const float metallic = static_cast<float>(metal(random));
        there.push_back({v[0], v[1], v[2], l[0], l[1], l[2], roughness, metallic});
        back.push_back({l[0], l[1], l[2], v[0], v[1], v[2], roughness, metallic});
    }
    const auto a = reflected(there);
    const auto b = reflected(back);
    for (size_t i = 0; i < a.size(); ++i) {
        for (size_t c = 0; c < 3; ++c) {
            const double one = a[i][c] / there[i][5];
            const double other = b[i][c] / back[i][5];
            CAPTURE(i, c, one, other);
            // Only the order of products and of two sums differs: in D and V nothing, in the Fresnel weights 6 roundings,
            // which (1 - weight) magnifies where a cosine nears 0: weight 0.9 at 0.02, so by 10.
            CHECK(std::abs(one - other) <= (12.0 + 10.0 * 11.0) * kRounding * std::max(one, other));
        }
    }
}

TEST_CASE("directions that make the original divide by 0 reflect a finite, non-negative amount", "[passes][brdf][defect 7]")
{
    std::vector<std::vector<float>> rows;
    for (const float roughness : {0.0f, 0.002f, 0.045f, 0.5f, 1.0f}) {
        for (const float metallic : {0.0f, 1.0f}) {
            for (const auto& v : {direction(1, 0, 0), direction(0, 1, 1e-7), direction(0, 0, 1), direction(1, 2, 3), direction(1, 0, -0.1)}) {
                rows.push_back({v[0], v[1], v[2], -v[0], -v[1], -v[2], roughness, metallic}); // opposite: h is 0
                rows.push_back({v[0], v[1], v[2], -v[0], -v[1], v[2], roughness, metallic});  // mirror direction
                rows.push_back({v[0], v[1], v[2], v[0], v[1], v[2], roughness, metallic});    // back where it came from
                rows.push_back({v[0], v[1], v[2], v[1], -v[0], 0.0f, roughness, metallic});   // along the surface
            }
        }
    }
    const auto got = reflected(rows);
    for (size_t i = 0; i < got.size(); ++i) {
        for (const float value : got[i]) {
            CAPTURE(i, value);
            CHECK(std::isfinite(value));
            CHECK(value >= 0.0f);
        }
    }
    for (size_t i = 3; i < got.size(); i += 4)
        CHECK(got[i] == std::vector<float>(3, 0.0f));
}

TEST_CASE("the distribution never exceeds its peak, and a half vector of length 0 has none", "[passes][brdf][defect 7]")
{
    const auto got = evaluate("ggx_distribution(c, s, c + s, 4.1e-6)", {"distribution.glsl"}, {"c", "s"},
                              {{1.0f, 0.0f}, {4.0f, 0.0f}, {1e-12f, 0.0f}, {0.0f, 0.0f}, {NAN, NAN}});
    for (size_t i = 0; i < 3; ++i)
        CHECK(got[i][0] == Approx(1.0 / (3.14159265358979324 * 4.1e-6)).epsilon(kDistribution));
    for (size_t i = 3; i < 5; ++i)
        CHECK(got[i][0] == 0.0f);
}

TEST_CASE("a material outside its range, or not a number, is lit as the nearest one inside", "[passes][brdf]")
{
    const auto l = direction(0.3, 0.1, 1.0);
    const auto with = [&](float roughness, float metallic) {
        return reflected({{0.0f, 0.0f, 1.0f, l[0], l[1], l[2], roughness, metallic}})[0];
    };
    CHECK(with(NAN, 0.0f) == with(0.0f, 0.0f));
    CHECK(with(-3.0f, 0.0f) == with(0.0f, 0.0f));
    CHECK(with(-INFINITY, 0.0f) == with(0.0f, 0.0f));
    CHECK(with(7.0f, 0.0f) == with(1.0f, 0.0f));
    CHECK(with(INFINITY, 0.0f) == with(1.0f, 0.0f));
    CHECK(with(0.5f, NAN) == with(0.5f, 0.0f));
    CHECK(with(0.5f, 2.0f) == with(0.5f, 1.0f));
    CHECK(with(0.5f, -2.0f) == with(0.5f, 0.0f));
}

TEST_CASE("a surface smoother than binary32 can light is lit as the smoothest that it can", "[passes][brdf]")
{
    const auto l = direction(0.01, 0.0, 1.0);
    const auto got = reflected({{0.0f, 0.0f, 1.0f, l[0], l[1], l[2], 0.0f, 1.0f}, {0.0f, 0.0f, 1.0f, l[0], l[1], l[2], 0.045f, 1.0f}});
    CHECK(got[0] == got[1]);
    CHECK(got[0][0] > 0.0f);
}

TEST_CASE("light from behind the surface is not reflected", "[passes][brdf]")
{
    const auto l = direction(0.3, -0.2, -0.01);
    for (const auto& value : reflected({{0.0f, 0.0f, 1.0f, l[0], l[1], l[2], 0.5f, 0.0f}, {0.0f, 0.6f, 0.8f, 0.0f, 0.0f, -1.0f, 0.1f, 1.0f}}))
        CHECK(value == std::vector<float>(3, 0.0f));
}

TEST_CASE("nothing jumps where an interpolated normal turns away from the viewer", "[passes][brdf]")
{
    const auto l = direction(0.2, 0.3, 0.9);
    std::vector<std::vector<float>> rows;
    for (const double z : {1e-5, -1e-5}) {
        const auto v = direction(0.6, 0.8, z);
        rows.push_back({v[0], v[1], v[2], l[0], l[1], l[2], 0.4f, 0.5f});
    }
    const auto got = reflected(rows);
    for (size_t c = 0; c < 3; ++c) {
        CHECK(got[0][c] > 0.0f);
        // The half vector moves by 2e-5; at roughness 0.4 D's slope is below 1 / alpha = 6.25 of that, squared.
        CHECK(got[1][c] == Approx(got[0][c]).epsilon(4e-4));
    }
}

TEST_CASE("seen along its normal a surface has the reflectance that glTF gives it", "[passes][brdf]")
{
    const auto got = evaluate("make_surface(vec3(0.9, 0.5, 0.1), vec3(specular, 0.5, metallic), 1.0, " + kDefaults + ").f0", {"brdf.glsl"},
                              {"specular", "metallic"}, {{0.5f, 0.0f}, {0.0f, 0.0f}, {1.0f, 0.0f}, {0.5f, 1.0f}});
    CHECK(got[0][0] == Approx(0.04).epsilon(1e-6));
    CHECK(got[1][2] == 0.0f);
    CHECK(got[2][1] == Approx(0.08).epsilon(1e-6));
    CHECK(got[3] == std::vector<float>{0.9f, 0.5f, 0.1f});
}
