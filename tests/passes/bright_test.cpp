// The bright pass: what lies above a soft threshold, and black, not nothing, below it.
#include <algorithm>
#include <cmath>
#include <vector>

#include "passes/expected.hpp"
#include "support/catch.hpp"
#include "support/pass_runner.hpp"

using namespace passgraph;
using namespace passgraph::test;

namespace {

double luminance_of(const Picture& p, int x, int y)
{
    return 0.2126 * p.at(x, y, 0) + 0.7152 * p.at(x, y, 1) + 0.0722 * p.at(x, y, 2);
}

double above(double brightness, double threshold, double knee)
{
    const double reach = threshold * knee;
    const double rise = std::clamp(brightness - threshold + reach, 0.0, 2.0 * reach);
    return std::max(reach > 0.0 ? rise * rise / (4.0 * reach) : 0.0, brightness - threshold);
}

} // namespace

TEST_CASE("the soft threshold is the table's", "[passes][bright]")
{
    const Table table = read_table("bloom_knee.csv");
    const std::vector<std::string> names = {"threshold", "knee_fraction", "brightness"};
    std::vector<std::vector<float>> rows;
    for (const auto& row : table.rows)
        rows.push_back({static_cast<float>(row[0]), static_cast<float>(row[1]), static_cast<float>(row[2])});
    REQUIRE(table.columns[2] == "brightness");
    const auto got = evaluate("above_threshold(brightness, threshold, knee_fraction)", {"soft_threshold.glsl"}, names, rows);
    for (size_t i = 0; i < rows.size(); ++i) {
        const double expected = table.rows[i][table.column("kept_brightness")];
        CAPTURE(rows[i][0], rows[i][1], rows[i][2], got[i][0], expected);
        // b - T + K cancels: two inputs' and two sums' roundings of at most b + T; the parabola's slope is at most 1, and
        // its square and quotient add 3 relative ones.
        CHECK(std::abs(got[i][0] - expected) <= 4.0 * kRounding * (rows[i][0] + rows[i][2]) + 3.0 * kRounding * expected);
    }
}

TEST_CASE("black keeps a share of 0, at any threshold", "[passes][bright]")
{
    // Asked of the function, because a pass's stores would hide a 0 / 0.
    for (const auto& value : evaluate("share_above_threshold(b, t, k)", {"soft_threshold.glsl"}, {"b", "t", "k"},
                                      {{0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 1.0f}, {0.0f, 0.8f, 0.5f}, {0.0f, 1.0f, 0.0f}}))
        CHECK(value[0] == 0.0f);
}

TEST_CASE("bright keeps the hue and the part above the threshold", "[passes][bright]")
{
    unsigned seed = 1;
    for (const Extent extent : kExtents) {
        const Picture image = noise(extent, 3, 0.0f, 3.0f, seed++);
        const Picture got = run_for_output({.pass = "bright", .inputs = {{"image", image}}});
        REQUIRE(got.extent == extent);
        const auto expected = [&](int x, int y, int c) {
            const double b = luminance_of(image, x, y);
            return image.at(x, y, c) * above(b, 0.8, 0.5) / b;
        };
        // Luminance 5 roundings of b, its distance to the threshold 2 of b + T; divided by b and times the channel. The
        // slope of kept / b is below 1 / b, so the sum is relative to the channel and T / b is bounded by 1 / 0.4 = 2.5
        // where anything is kept at all.
        require_texels(got, expected, [&](int x, int y, int c) { return 25.0 * kRounding * image.at(x, y, c); });
    }
}

TEST_CASE("below the knee bright is exactly black, where the original left memory as it was", "[passes][bright][defect 6]")
{
    // T - K is 0.4; a luminance of at most 0.39 is safely below.
    const Picture dark = noise({17, 13}, 3, 0.0f, 0.39f, 5);
    require_same(run_for_output({.pass = "bright", .inputs = {{"image", dark}}}), constant({17, 13}, {0.0f, 0.0f, 0.0f}));
    const Picture black = constant({1, 1}, {0.0f, 0.0f, 0.0f});
    require_same(run_for_output({.pass = "bright", .inputs = {{"image", black}}}), black);
}

TEST_CASE("bright with a threshold of 0 is its input", "[passes][bright][identity]")
{
    const Picture image = noise({17, 13}, 3, 0.0f, 100.0f, 6);
    for (const char* knee : {"0", "0.5", "1"})
        require_same(run_for_output({.pass = "bright", .inputs = {{"image", image}}, .settings = {{"threshold", "0"}, {"knee", knee}}}), image);
}

TEST_CASE("a knee of 0 is a hard threshold", "[passes][bright]")
{
    Picture image({3, 1}, 3);
    for (int c = 0; c < 3; ++c) {
        image.at(0, 0, c) = 0.99f;
        image.at(1, 0, c) = 3.0f;
        image.at(2, 0, c) = 0.0f;
    }
    const Picture got = run_for_output({.pass = "bright", .inputs = {{"image", image}}, .settings = {{"threshold", "1"}, {"knee", "0"}}});
    for (int c = 0; c < 3; ++c) {
        CHECK(got.at(0, 0, c) == 0.0f);
        CHECK(got.at(1, 0, c) == Approx(2.0).epsilon(20.0 * kRounding));
        CHECK(got.at(2, 0, c) == 0.0f);
    }
}

TEST_CASE("the brightest radiance of all is kept finite", "[passes][bright]")
{
    const Picture got = run_for_output({.pass = "bright", .inputs = {{"image", constant({2, 2}, {65504.0f, 65504.0f, 65504.0f})}}});
    require_texels(got, [](int, int, int) { return 65504.0 - 0.8; }, 25.0 * kRounding * 65504.0);
}
