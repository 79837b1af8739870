// Images as people see them.
#include <cmath>

#include <passgraph/gl/presenter.hpp>

#include "gl_support.hpp"

using namespace passgraph;
using namespace passgraph::test;

namespace {

/// What is shown of a plan whose one step writes `value` into an image of this signal and codec.
Picture shown(Signal signal, const std::string& codec, const std::string& value, Vec3 low = {0, 0, 0}, Vec3 high = {1, 1, 1})
{
    const Codec& stored = *find_codec(signal, codec);
    PlanBuilder builder({2, 2});
    const int slot = builder.slot(stored.format, "image");
    builder.draw("fill", std::string(glsl_codec_functions()) + "layout(location = 0) out vec4 color;\nvoid main() { color = " + glsl_encode_call(signal, stored, value) + "; }", {slot});
    builder.output("image", slot, signal, codec);
    Renderer renderer = make_renderer(builder.plan);
    require_ok(renderer.render());
    const Result<std::vector<StoredCodes>> codes = renderer.codes("image");
    REQUIRE(codes);
    Result<Presenter> presenter = Presenter::create(test_loader());
    REQUIRE(presenter);
    const Result<Picture> picture = presenter->read({*codes, signal, stored, low, high});
    if (!picture)
        FAIL(to_text(picture.error()));
    CHECK(picture->extent == Extent{2, 2});
    return *picture;
}

constexpr double kCode = 0.5001 / 255.0; // half a code of the copy, and the roundings before it

void check(const Picture& picture, std::array<double, 3> expected, double margin = kCode)
{
    for (int c = 0; c < 3; ++c) {
        CAPTURE(c);
        CHECK(static_cast<double>(picture.at(1, 1, c)) == Approx(expected[static_cast<size_t>(c)]).margin(margin));
    }
}

double srgb(double x) { return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055; }

} // namespace

TEST_CASE("a display image is shown code by code", "[gl][presenter]")
{
    check(shown(Signal::display, "rgba8", "vec3(17.0, 128.0, 255.0) / 255.0"), {17.0 / 255.0, 128.0 / 255.0, 1.0}, 1e-6);
}

TEST_CASE("each signal has a scale that fits its values", "[gl][presenter]")
{
    check(shown(Signal::radiance, "rgba32f", "vec3(0.0, 1.0, 4.0)"), {0.0, srgb(0.5), srgb(0.8)});
    check(shown(Signal::albedo, "rgba32f", "vec3(0.0, 0.5, 1.0)"), {0.0, srgb(0.5), 1.0});
    check(shown(Signal::normal, "octahedral_rg16", "vec3(0.6, 0.0, 0.8)"), {0.8, 0.5, 0.9});
    check(shown(Signal::mask, "r32f", "0.25"), {0.25, 0.25, 0.25});
    check(shown(Signal::material, "rgba32f", "vec3(0.5, 0.25, 1.0)"), {0.5, 0.25, 1.0});
    check(shown(Signal::velocity, "rg32f", "vec2(16.0, -16.0)"), {0.75, 0.25, 0.5});
}

TEST_CASE("depth and position are shown between given ends", "[gl][presenter]")
{
    // 1 / d = 4, between 8 (black, far) and 2 (white, near).
    check(shown(Signal::depth, "r32f", "0.25", {8, 8, 8}, {2, 2, 2}), {4.0 / 6.0, 4.0 / 6.0, 4.0 / 6.0});
    check(shown(Signal::depth, "r32f", "0.0", {8, 8, 8}, {2, 2, 2}), {0.0, 0.0, 0.0}); // nothing there
    check(shown(Signal::position, "rgba32f", "vec3(-5.0, 0.0, -100.0)", {-10, -10, -100}, {10, 10, -50}), {0.25, 0.5, 0.0});
}

TEST_CASE("an image keeps its aspect in a window of another", "[gl][presenter]")
{
    const auto is = [](const Presenter::Place& place, int x, int y, Extent extent) { return place.x == x && place.y == y && place.extent == extent; };
    CHECK(is(Presenter::place_of({320, 180}, {320, 180}), 0, 0, {320, 180}));
    CHECK(is(Presenter::place_of({160, 90}, {320, 180}), 0, 0, {320, 180}));
    CHECK(is(Presenter::place_of({320, 180}, {320, 380}), 0, 100, {320, 180}));
    CHECK(is(Presenter::place_of({100, 100}, {400, 200}), 100, 0, {200, 200}));
    CHECK(is(Presenter::place_of({1000, 1}, {10, 10}), 0, 4, {10, 1}));
}
