// Tone mapping: the filmic curve and the sRGB curve against 50-digit tables, and one encoding only.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "passes/expected.hpp"
#include "support/catch.hpp"
#include "support/pass_runner.hpp"

using namespace passgraph;
using namespace passgraph::test;

namespace {

std::vector<std::vector<float>> rows_of(const Table& table, const std::string& curve, std::vector<double>& expected)
{
    std::vector<std::vector<float>> rows;
    for (size_t i = 0; i < table.rows.size(); ++i) {
        if (table.text[i][table.column("curve")] != curve)
            continue;
        rows.push_back({static_cast<float>(table.rows[i][table.column("x")])});
        expected.push_back(table.rows[i][table.column("y")]);
    }
    return rows;
}

/// Hable's curve as published, and its value at white.
double published_hable(double x)
{
    return ((x * (0.22 * x + 0.10 * 0.30) + 0.20 * 0.01) / (x * (0.22 * x + 0.30) + 0.20 * 0.30)) - 0.01 / 0.30;
}

double shown(double radiance, double white)
{
    const double x = published_hable(std::min(radiance, white)) / published_hable(white);
    return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055;
}

Picture toned(const Picture& image, const std::string& exposure = "1", const std::string& white = "11.2",
              const std::string& transfer = "exact")
{
    return run_for_output({.pass = "tone_map",
                           .inputs = {{"image", image}},
                           .settings = {{"exposure", exposure}, {"white", white}, {"transfer", transfer}}});
}

// pow(x, 1 / 2.4) is 4.3 ulp off on llvmpipe, 8.6 roundings, times 1.055; the curve's 24 relative roundings are damped by
// 1 / 2.4 above the joint and multiplied by 12.92 x < 0.041 below it; product and difference add 3.
constexpr double kShown = (1.055 * 8.6 + 10.0 + 3.0) * kRounding;
// The rational transfer is 1.31e-4 off in exact arithmetic; its square root, quotient and six more operations round, and the
// largest intermediate value, near 6, is divided again.
constexpr double kRational = 1.31e-4 + (10.0 + 10.0) * kRounding;

} // namespace

TEST_CASE("the filmic curve is the table's, for the constants of Hable's talk", "[passes][tone_map]")
{
    std::vector<double> expected;
    const auto rows = rows_of(read_table("curves.csv"), "hable_w11.2_exp2", expected);
    REQUIRE(rows.size() > 25);
    const auto got = evaluate("hable(2.0 * x, 11.2, vec3(0.15, 0.50, 0.10), vec3(0.20, 0.02, 0.30))", {"hable.glsl"}, {"x"}, rows);
    for (size_t i = 0; i < rows.size(); ++i) {
        CAPTURE(rows[i][0], got[i][0], expected[i]);
        // Relative: C F - E = 0.03 - 0.02 magnifies its 3 roundings 3 times, in the curve and in its value at white; the
        // rest is positive: input 1, numerator 4, denominator 5, quotients 2. A subnormal input may count as 0.
        CHECK(std::abs(got[i][0] - expected[i]) <= 30.0 * kRounding * expected[i] + 1e-37);
    }
}

TEST_CASE("the sRGB curve is the table's", "[passes][tone_map]")
{
    std::vector<double> expected;
    const auto rows = rows_of(read_table("curves.csv"), "srgb_encode_clamped", expected);
    REQUIRE(rows.size() > 25);
    const auto got = evaluate("srgb_encode(clamp(x, 0.0, 1.0))", {"srgb.glsl"}, {"x"}, rows);
    for (size_t i = 0; i < rows.size(); ++i) {
        CAPTURE(rows[i][0], got[i][0], expected[i]);
        CHECK(std::abs(got[i][0] - expected[i]) <= kShown);
    }
}

TEST_CASE("the sRGB curve's two pieces meet", "[passes][tone_map]")
{
    const float joint = 0.0031308f;
    const auto got = evaluate("srgb_encode(x)", {"srgb.glsl"}, {"x"}, {{std::nextafter(joint, 0.0f)}, {joint}, {std::nextafter(joint, 1.0f)}});
    // 3e-8 is the step of the standard's own constants; two steps of the input are 6e-9; the rest is pow's.
    CHECK(std::abs(got[2][0] - got[0][0]) <= 3e-8 + 6e-9 + kShown * 0.1);
}

TEST_CASE("tone mapping is Hable's curve as published, encoded once", "[passes][tone_map]")
{
    unsigned seed = 70;
    for (const Extent extent : kExtents) {
        const Picture image = noise(extent, 3, 0.0f, 14.0f, seed++);
        require_texels(toned(image), [&](int x, int y, int c) { return shown(image.at(x, y, c), 11.2); }, kShown);
        require_texels(toned(image, "0.3", "4"), [&](int x, int y, int c) { return shown(0.3 * image.at(x, y, c), 4.0); }, kShown);
        require_texels(toned(image, "1", "11.2", "rational"), [&](int x, int y, int c) { return shown(image.at(x, y, c), 11.2); }, kRational);
    }
}

TEST_CASE("black stays black, white and beyond is 1", "[passes][tone_map][identity]")
{
    require_same(toned(constant({3, 1}, {0.0f, 0.0f, 0.0f})), constant({3, 1}, {0.0f, 0.0f, 0.0f}));
    require_texels(toned(constant({3, 1}, {11.2f, 100.0f, 65504.0f})), [](int, int, int) { return 1.0; }, kShown);
    require_texels(toned(constant({3, 1}, {65504.0f, 0.2f, 1.0f}), "100"), [](int, int, int) { return 1.0; }, kShown);
    require_same(toned(constant({3, 1}, {0.0f, 0.0f, 0.0f}), "1", "11.2", "rational"), constant({3, 1}, {0.0f, 0.0f, 0.0f}));
    require_texels(toned(constant({3, 1}, {11.2f, 100.0f, 65504.0f}), "1", "11.2", "rational"), [](int, int, int) { return 1.0; }, 10.0 * kRounding);
}

TEST_CASE("an exposure of 2 is twice the radiance", "[passes][tone_map][identity]")
{
    Picture image = noise({17, 13}, 3, 0.0f, 8.0f, 75);
    const Picture exposed = toned(image, "2");
    for (float& value : image.texels)
        value *= 2.0f;
    require_same(exposed, toned(image));
}

TEST_CASE("a brighter radiance is never shown darker", "[passes][tone_map]")
{
    Picture image({2000, 1}, 3);
    for (int x = 0; x < 2000; ++x)
        image.at(x, 0, 0) = static_cast<float>(1e-6 * std::pow(2e7, x / 1999.0));
    for (const char* transfer : {"exact", "rational"}) {
        CAPTURE(transfer);
        const Picture got = toned(image, "1", "11.2", transfer);
        for (int x = 1; x < 2000; ++x)
            CHECK(got.at(x, 0, 0) >= got.at(x - 1, 0, 0) - 4.0 * kRounding * got.at(x, 0, 0));
    }
}

TEST_CASE("the curve of no number, of less than nothing and of infinity is that of black and white", "[passes][tone_map]")
{
    const auto got = evaluate("hable(x, 11.2, vec3(0.22, 0.30, 0.10), vec3(0.20, 0.01, 0.30))", {"hable.glsl"}, {"x"}, {{NAN}, {-INFINITY}, {-1.0f}, {INFINITY}, {1e30f}});
    CHECK(got[0][0] == 0.0f);
    CHECK(got[1][0] == 0.0f);
    CHECK(got[2][0] == 0.0f);
    CHECK(got[3][0] == Approx(1.0).epsilon(1e-6));
    CHECK(got[4][0] == Approx(1.0).epsilon(1e-6));
}
