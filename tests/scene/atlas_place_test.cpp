// Wrap modes, levels and places on the host, where inputs are anything a vertex may hold.
#include <cmath>
#include <limits>

#include "scene/atlas_scenes.hpp"

using namespace passgraph;

namespace {

constexpr std::array<Wrap, 3> kWraps{Wrap::repeat, Wrap::mirror, Wrap::clamp};

} // namespace

TEST_CASE("any coordinate at all lands inside the cell", "[scene][atlas]")
{
    const float infinity = std::numeric_limits<float>::infinity();
    for (const Wrap wrap : kWraps) {
        for (float x = 1e-40f; x < 3e38f; x *= 1.7f) {
            for (const float at : {x, -x, 1.0f - x, x - 1.0f}) {
                const float inside = atlas_wrap(at, wrap);
                CAPTURE(at, static_cast<int>(wrap), inside);
                REQUIRE(inside >= 0.0f);
                REQUIRE((wrap == Wrap::repeat ? inside < 1.0f : inside <= 1.0f));
            }
        }
        CHECK(atlas_wrap(std::nanf(""), wrap) == 0.0f);
        CHECK(atlas_wrap(-infinity, wrap) == 0.0f);
        CHECK(atlas_wrap(infinity, wrap) == (wrap == Wrap::clamp ? 1.0f : 0.0f));
        for (const float x : {0.0f, 1e-9f, 0.25f, 0.99999994f})
            CHECK(atlas_wrap(x, wrap) == x);
    }
}

TEST_CASE("a coordinate just below a whole number repeats to the end of the cell, not past it", "[scene][atlas]")
{
    CHECK(atlas_wrap(-1e-7f, Wrap::repeat) == 0.9999999f);
    CHECK(atlas_wrap(-1e-9f, Wrap::repeat) == 0.99999994f);
    CHECK(atlas_wrap(1.0f, Wrap::repeat) == 0.0f);
    CHECK(atlas_wrap(-1.0f, Wrap::repeat) == 0.0f);
}

TEST_CASE("a mirrored coordinate goes to and fro", "[scene][atlas]")
{
    for (const int turn : {-4, -2, 0, 2, 6}) {
        const auto base = static_cast<float>(turn);
        CHECK(atlas_wrap(base + 0.25f, Wrap::mirror) == 0.25f);
        CHECK(atlas_wrap(base + 1.0f, Wrap::mirror) == 1.0f);
        CHECK(atlas_wrap(base + 1.25f, Wrap::mirror) == 0.75f);
        CHECK(atlas_wrap(base - 0.25f, Wrap::mirror) == 0.25f);
    }
    CHECK(atlas_wrap(-1e-9f, Wrap::mirror) <= 1e-7f);
}

TEST_CASE("the level is the rounded logarithm of the longer gradient", "[scene][atlas]")
{
    for (int i = -40; i <= 200; ++i) {
        const double length = std::exp2(0.0625 * i + 0.01);
        const int expected = static_cast<int>(std::min(9.0, std::max(0.0, std::round(std::log2(length)))));
        CAPTURE(length);
        const auto texels = static_cast<float>(length);
        CHECK(atlas_level({texels, 0}, {0, 0.5f * texels}, 9) == expected);
        CHECK(atlas_level({0, 0.5f * texels}, {0, -texels}, 9) == expected);
        CHECK(atlas_level({0.6f * texels, -0.8f * texels}, {0, 0}, 9) == expected);
    }
}

TEST_CASE("a gradient that is no number or no end gives a level that exists", "[scene][atlas]")
{
    const float nan = std::nanf("");
    const float infinity = std::numeric_limits<float>::infinity();
    CHECK(atlas_level({0, 0}, {0, 0}, 7) == 0);
    CHECK(atlas_level({nan, 0}, {nan, nan}, 7) == 0);
    CHECK(atlas_level({infinity, 0}, {0, 0}, 7) == 7);
    CHECK(atlas_level({0, 0}, {3e38f, 3e38f}, 7) == 7);
    CHECK(atlas_level({1e9f, 0}, {0, 0}, 0) == 0);
    for (const float x : {nan, infinity, -infinity, 1e30f}) {
        for (const Wrap wrap : kWraps) {
            const glm::vec2 place = atlas_place({5, 9, 4, 2}, {atlas_wrap(x, wrap), atlas_wrap(-x, wrap)});
            CHECK((place.x >= 5 && place.x <= 9 && place.y >= 9 && place.y <= 11));
        }
    }
}
