// Places in the texture atlas: the shader's functions against a table, and against those of the host.
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <passgraph/scene/atlas.hpp>

#include "passes/expected.hpp"
#include "support/catch.hpp"
#include "support/pass_runner.hpp"

using namespace passgraph;
using namespace passgraph::test;

namespace {

using Rows = std::vector<std::vector<float>>;

Rows in_shader(const std::string& expression, const std::vector<std::string>& columns, const Rows& rows)
{
    return evaluate(expression, {"atlas.glsl"}, columns, rows);
}

const float kInfinity = std::numeric_limits<float>::infinity();

/// Coordinates around everything that is special about wrapping, and some that are not.
std::vector<float> coordinates()
{
    std::vector<float> all{kInfinity, -kInfinity, std::nanf(""), 1e10f, -1e10f, 3e38f, -3e38f};
    for (const float base : {-3.0f, -2.0f, -1.0f, 0.0f, 1.0f, 2.0f, 3.0f, 1000.0f})
        for (const float step : {0.0f, 1e-9f, -1e-9f, 1e-7f, -1e-7f, 6e-8f, -6e-8f, 0.25f, 0.5f})
            all.push_back(base + step);
    for (const float tiny : {1e-9f, 1e-20f, 1e-37f})
        all.insert(all.end(), {tiny, -tiny});
    std::mt19937 random(41);
    std::uniform_real_distribution<float> anywhere(-5.0f, 5.0f);
    for (int i = 0; i < 200; ++i)
        all.push_back(anywhere(random));
    return all;
}

} // namespace

TEST_CASE("a repeated coordinate and its place in the atlas are those of the table", "[passes][atlas]")
{
    const Table table = read_table("atlas_repeat.csv");
    const size_t width = table.column("atlas_width");
    const size_t x = table.column("tile_x");
    const size_t w = table.column("tile_w");
    const size_t u = table.column("u");
    const size_t fraction = table.column("fract_u");
    const size_t place = table.column("atlas_u");
    Rows rows;
    for (const auto& row : table.rows)
        rows.push_back({static_cast<float>(row[u]), static_cast<float>(row[x]), static_cast<float>(row[w])});
    const auto wrapped = in_shader("atlas_wrap(u, 0)", {"u", "x", "w"}, rows);
    const auto placed = in_shader("atlas_place(vec4(x, 0.0, w, 1.0), vec2(atlas_wrap(u, 0), 0.0)).x", {"u", "x", "w"}, rows);
    REQUIRE(rows.size() > 30);
    for (size_t i = 0; i < rows.size(); ++i) {
        const auto& row = table.rows[i];
        CAPTURE(row[width], row[x], row[w], row[u]);
        // One rounding of u, which near 0 and 1 is one of a number below 1, and the table's own decimals.
        CHECK(std::abs(wrapped[i][0] - row[fraction]) <= 2 * kRounding);
        CHECK(wrapped[i][0] < 1.0f);
        CHECK(wrapped[i][0] == atlas_wrap(rows[i][0], Wrap::repeat));
        // The table is for an atlas without gutters, which keeps half a texel away from the border; ours need not.
        const double inset = std::min(std::max(static_cast<double>(placed[i][0]), row[x] + 0.5), row[x] + row[w] - 0.5);
        CHECK(std::abs(inset / row[width] - row[place]) <= 1e-6);
    }
}

TEST_CASE("the shader wraps every coordinate to the same bits as the host", "[passes][atlas]")
{
    for (const Wrap wrap : {Wrap::repeat, Wrap::mirror, Wrap::clamp}) {
        Rows rows;
        for (const float x : coordinates())
            rows.push_back({x, static_cast<float>(wrap)});
        const auto got = in_shader("atlas_wrap(x, int(mode))", {"x", "mode"}, rows);
        for (size_t i = 0; i < rows.size(); ++i) {
            CAPTURE(static_cast<int>(wrap), rows[i][0]);
            CHECK(got[i][0] == atlas_wrap(rows[i][0], wrap));
            CHECK((got[i][0] >= 0.0f && got[i][0] <= 1.0f));
        }
    }
}

TEST_CASE("the shader chooses the level that the host does, and always one that exists", "[passes][atlas]")
{
    std::vector<float> lengths{0.0f, 1e-20f, 0.7f, 1.0f, 1.41f, 1.4143f, 2.82f, 2.83f, 1e6f, 1e19f, 3e38f, kInfinity, std::nanf("")};
    std::mt19937 random(43);
    std::uniform_real_distribution<float> exponent(-3.0f, 13.0f);
    for (int i = 0; i < 60; ++i)
        lengths.push_back(std::exp2(exponent(random)));
    Rows rows;
    for (const float a : lengths)
        for (const float b : {a, 0.0f, -0.5f * a, 3.0f, kInfinity, std::nanf("")})
            for (const float last : {0.0f, 5.0f, 12.0f})
                rows.push_back({a, b, last});
    const auto along_x = in_shader("float(atlas_level(vec2(a, 0.0), vec2(0.0, b), int(last)))", {"a", "b", "last"}, rows);
    const auto along_y = in_shader("float(atlas_level(vec2(0.0, b), vec2(a, 0.0), int(last)))", {"a", "b", "last"}, rows);
    for (size_t i = 0; i < rows.size(); ++i) {
        const float a = rows[i][0];
        const float b = rows[i][1];
        const auto last = static_cast<int>(rows[i][2]);
        CAPTURE(a, b, last);
        CHECK(static_cast<int>(along_x[i][0]) == atlas_level({a, 0}, {0, b}, last));
        CHECK(static_cast<int>(along_y[i][0]) == atlas_level({0, b}, {a, 0}, last));
        CHECK((along_x[i][0] >= 0.0f && along_x[i][0] <= rows[i][2]));
    }
}

TEST_CASE("whatever the coordinates, a place is inside its rectangle", "[passes][atlas]")
{
    Rows rows;
    for (const float x : coordinates())
        for (const float mode : {0.0f, 1.0f, 2.0f})
            rows.push_back({x, mode});
    const auto got = in_shader("atlas_place(vec4(1001.0, 7.0, 333.0, 1.0), vec2(atlas_wrap(x, int(mode)), atlas_wrap(-x, int(mode))))",
                               {"x", "mode"}, rows);
    for (size_t i = 0; i < rows.size(); ++i) {
        CAPTURE(rows[i][0], rows[i][1], got[i][0], got[i][1]);
        CHECK((got[i][0] >= 1001.0f && got[i][0] <= 1334.0f));
        CHECK((got[i][1] >= 7.0f && got[i][1] <= 8.0f));
    }
}
