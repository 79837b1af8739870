// Vignette: darker with the distance from the center, by a factor and never below black.
#include <algorithm>
#include <cmath>
#include <string>

#include "passes/expected.hpp"
#include "support/catch.hpp"
#include "support/pass_runner.hpp"

using namespace passgraph;
using namespace passgraph::test;

namespace {

Picture darkened(const Picture& image, std::vector<std::pair<std::string, std::string>> settings, Signal signal = Signal::radiance)
{
    return run_for_output({.pass = "vignette", .inputs = {{"image", image}}, .settings = std::move(settings), .generic = signal});
}

double smooth(double t)
{
    t = std::clamp(t, 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

double radius_at(Extent extent, int x, int y, bool is_circle)
{
    const double u = (x + 0.5) / extent.width - 0.5;
    const double v = (y + 0.5) / extent.height - 0.5;
    return is_circle ? 2.0 * std::hypot(u * extent.width, v * extent.height) / std::hypot(extent.width, extent.height)
                     : std::sqrt(2.0) * std::hypot(u, v);
}

/// uv - 1/2 carries 2 roundings of 1, the length 4, the quotient by outer - inner >= 0.4 magnifies them 2.5 times and
/// smoothstep's slope 1.5 times; smoothstep itself, amount and product add 8. Relative to the brightest texel.
constexpr double kTolerance = (8.0 * 2.5 * 1.5 + 8.0) * kRounding;

} // namespace

TEST_CASE("a vignette from 0 to 1 shows the table's radii", "[passes][vignette]")
{
    const Table table = read_table("vignette_radius.csv");
    for (const auto& row : table.rows) {
        const Extent extent{static_cast<int>(row[table.column("w")]), static_cast<int>(row[table.column("h")])};
        const int x = static_cast<int>(row[table.column("px")]);
        const int y = static_cast<int>(row[table.column("py")]);
        const Picture white = constant(extent, {1.0f, 1.0f, 1.0f});
        CAPTURE(extent.width, extent.height, x, y);
        const Picture ellipse = darkened(white, {{"inner", "0"}, {"outer", "1"}});
        CHECK(ellipse.at(x, y, 1) == Approx(1.0 - smooth(row[table.column("r_uv_over_corner")])).margin(kTolerance));
        const Picture circle = darkened(white, {{"inner", "0"}, {"outer", "1"}, {"shape", "circle"}});
        CHECK(circle.at(x, y, 1) == Approx(1.0 - smooth(row[table.column("r_pixels_over_corner")])).margin(kTolerance));
    }
}

TEST_CASE("a vignette multiplies by one minus a smooth step of the radius", "[passes][vignette]")
{
    unsigned seed = 100;
    for (const Extent extent : kExtents) {
        const Picture image = noise(extent, 3, 0.0f, 4.0f, seed++);
        for (const bool is_circle : {false, true}) {
            const auto expected = [&](int x, int y, int c) {
                return image.at(x, y, c) * (1.0 - 0.7 * smooth((radius_at(extent, x, y, is_circle) - 0.5) / 0.4));
            };
            require_texels(darkened(image, {{"amount", "0.7"}, {"shape", is_circle ? "circle" : "ellipse"}}), expected, 4.0 * kTolerance);
        }
    }
}

TEST_CASE("a vignette of amount 0 is its input", "[passes][vignette][identity]")
{
    const Picture image = noise({17, 13}, 3, 0.0f, 4.0f, 105);
    require_same(darkened(image, {{"amount", "0"}}), image);
}

TEST_CASE("a picture of one texel is all center", "[passes][vignette][identity]")
{
    const Picture image = constant({1, 1}, {0.3f, 1.0f, 4.0f});
    for (const char* shape : {"ellipse", "circle"})
        require_same(darkened(image, {{"shape", shape}, {"inner", "0"}}), image);
}

TEST_CASE("a mirror image has a mirrored vignette", "[passes][vignette]")
{
    const Picture image = noise({17, 13}, 3, 0.0f, 4.0f, 106);
    const Picture straight = mirrored(darkened(image, {}));
    require_texels(darkened(mirrored(image), {}), [&](int x, int y, int c) { return straight.at(x, y, c); }, 8.0 * kTolerance);
}

TEST_CASE("no color goes below black, where the original subtracts", "[passes][vignette][defect 9]")
{
    const Picture dark = noise({17, 13}, 3, 0.0f, 0.05f, 107);
    const Picture got = darkened(dark, {{"inner", "0"}, {"outer", "0.1"}});
    require_texels(got, [](int, int, int) { return 0.025; }, 0.025);
    CHECK(got.at(0, 0, 0) == 0.0f);
}

TEST_CASE("alpha is carried, where the original darkens it too", "[passes][vignette][defect 9]")
{
    const Picture image = constant({17, 13}, {0.5f, 0.5f, 0.5f, 0.75f});
    const Picture got = darkened(image, {{"inner", "0"}, {"outer", "0.1"}}, Signal::radiance_alpha);
    REQUIRE(got.channels == 4);
    CHECK(got.at(0, 0, 0) == 0.0f);
    CHECK(got.at(0, 0, 3) == 0.75f);
}

TEST_CASE("an inner radius at or beyond the outer is a sharp edge", "[passes][vignette]")
{
    const Extent extent{17, 13};
    const Picture white = constant(extent, {1.0f, 1.0f, 1.0f});
    for (const char* outer : {"0.6", "0.2", "0"}) {
        const Picture got = darkened(white, {{"inner", "0.6"}, {"outer", outer}});
        require_texels(got, [&](int x, int y, int) { return radius_at(extent, x, y, false) > 0.6 ? 0.0 : 1.0; }, 0.0);
    }
}
