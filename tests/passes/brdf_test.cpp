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

// Roundings in units of 2^-24, relative, all sums being of positive terms:
// D: alpha^2 3, bracket 3 + 4, twice in its square + 1, numerator 2, quotient 1 and llvmpipe's half ulp: 21.
// F: 1 - cos 1, fifth power 5 + 3, product and sum 2: 11.  V: alpha^2 3, 1 - alpha^2 1, root 4, products and sum 4: 12.
constexpr double kDistribution = 21.0 * kRounding;
constexpr double kFresnel = 11.0 * kRounding;
constexpr double kVisibility = 12.0 * kRounding;
constexpr double kSpecular = kDistribution + kFresnel + kVisibility + 2.0 * kRounding;

std::vector<std::vector<float>> columns_of(const Table& table, const std::vector<std::string>& names)
{
    std::vector<std::vector<float>> rows;
    for (const auto& row : table.rows) {
        rows.emplace_back();
        for (const auto& name : names)
            rows.back().push_back(static_cast<float>(row[table.column(name)]));
    }
    return rows;
}

std::array<float, 3> direction(double x, double y, double z)
{
    const double length = std::sqrt(x * x + y * y + z * z);
    return {static_cast<float>(x / length), static_cast<float>(y / length), static_cast<float>(z / length)};
}

const std::vector<std::string> kDirections = {"vx", "vy", "vz", "lx", "ly", "lz", "roughness", "metallic"};
const std::string kReflected = "reflected(make_surface(vec3(0.9, 0.5, 0.1), vec3(0.5, roughness, metallic), vz), "
                               "vec3(0.0, 0.0, 1.0), vec3(vx, vy, vz), vec3(lx, ly, lz))";

std::vector<std::vector<float>> reflected(const std::vector<std::vector<float>>& rows)
{
    return evaluate(kReflected, {"brdf.glsl"}, kDirections, rows);
}

} // namespace

TEST_CASE("each term of the specular lobe is the table's", "[passes][brdf]")
{
    const Table table = read_table("brdf_terms.csv");
    const std::vector<std::string> names = {"roughness", "f0", "NoL", "NoV", "NoH", "VoH"};
    const std::string alpha = "roughness * roughness * roughness * roughness";
    const std::string cosines = "NoH * NoH, (1.0 - NoH) * (1.0 + NoH)";
    const auto got = evaluate("vec4(ggx_distribution(" + cosines + ", " + alpha + "), fresnel(vec3(f0), VoH).x, "
                              "4.0 * max(NoL, 0.0) * max(NoV, 0.0) * smith_visibility(max(NoL, 0.0), max(NoV, 0.0), " + alpha + "), "
                              "fresnel(vec3(f0), VoH).x * ggx_lobe(NoL, NoV, " + cosines + ", " + alpha + "))",
                              {"brdf.glsl"}, names, columns_of(table, names));
    REQUIRE(got.size() == table.rows.size());
    const auto check = [&](size_t row, float value, const std::string& column, double relative) {
        const double expected = table.rows[row][table.column(column)];
        CAPTURE(column, table.rows[row][0], value, expected);
        CHECK(std::isfinite(value));
        CHECK(std::abs(value - expected) <= relative * std::abs(expected));
    };
    for (size_t i = 0; i < got.size(); ++i) {
        // The table cuts D off at the horizon; here that cut is ggx_lobe's, as it is one of the whole product.
        if (table.rows[i][table.column("NoH")] > 0.0)
            check(i, got[i][0], "D_ggx", kDistribution);
        check(i, got[i][1], "F_schlick", kFresnel);
        check(i, got[i][2], "G_smith_corr_ggx", kVisibility + 4.0 * kRounding);
        check(i, got[i][3], "spec_smith_corr_ggx", kSpecular);
    }
}

TEST_CASE("the specular lobe of two directions is the table's", "[passes][brdf]")
{
    const Table table = read_table("brdf_vectors.csv");
    const std::vector<std::string> names = {"roughness", "f0", "Vx", "Vy", "Vz", "Lx", "Ly", "Lz"};
    const auto got = evaluate("reflected(make_surface(vec3(f0), vec3(0.0, roughness, 1.0), Vz), vec3(0.0, 0.0, 1.0), "
                              "vec3(Vx, Vy, Vz), vec3(Lx, Ly, Lz)).x",
                              {"brdf.glsl"}, names, columns_of(table, names));
    REQUIRE(got.size() == table.rows.size());
    int compared = 0;
    for (size_t i = 0; i < got.size(); ++i) {
        const auto& row = table.rows[i];
        const double expected = row[table.column("specNoL_smith_corr_ggx")];
        CAPTURE(row[0], got[i][0], expected);
        CHECK(got[i][0] >= 0.0f);
        CHECK(std::isfinite(got[i][0]));
        // Outside what make_surface clamps; there the value differs by design.
        if (row[table.column("roughness")] < 0.045 || row[table.column("Vz")] < 1e-4)
            continue;
        ++compared;
        // Directions of binary32 are of length 1 within 2^-24 each way: |h| / 2 is v.h / |h| within 1e-7, and Schlick's
        // slope magnifies that at most 6.6 times at the table's smallest f0. The sums h add 2 roundings to each of D's sines.
        CHECK(std::abs(got[i][0] - expected) <= (kSpecular + 12.0 * kRounding + 6.6e-7) * expected);
    }
    CHECK(compared > 40);
}

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

TEST_CASE("the distribution never exceeds its peak, not even for a half vector of length 0", "[passes][brdf][defect 7]")
{
    const auto got = evaluate("ggx_distribution(c, s, 4.1e-6)", {"brdf.glsl"}, {"c", "s"}, {{0.0f, 0.0f}, {NAN, NAN}, {1.0f, 0.0f}});
    for (const auto& value : got)
        CHECK(value[0] == Approx(1.0 / (3.14159265358979324 * 4.1e-6)).epsilon(kDistribution));
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
    const auto got = evaluate("make_surface(vec3(0.9, 0.5, 0.1), vec3(specular, 0.5, metallic), 1.0).f0", {"brdf.glsl"},
                              {"specular", "metallic"}, {{0.5f, 0.0f}, {0.0f, 0.0f}, {1.0f, 0.0f}, {0.5f, 1.0f}});
    CHECK(got[0][0] == Approx(0.04).epsilon(1e-6));
    CHECK(got[1][2] == 0.0f);
    CHECK(got[2][1] == Approx(0.08).epsilon(1e-6));
    CHECK(got[3] == std::vector<float>{0.9f, 0.5f, 0.1f});
}
