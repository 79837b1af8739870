// What a surface is made of, read from the atlas at the place that the G-buffer names.
#include "passes/expected.hpp"
#include "support/catch.hpp"
#include "support/pass_runner.hpp"

using namespace passgraph;
using namespace passgraph::test;

namespace {

/// Two pixels, one without a surface, over an atlas of one color each.
std::map<std::string, Picture> read_atlas()
{
    Picture places = constant({2, 1}, {0.0f, 0.0f});
    places.at(1, 0, 0) = 0.5f;
    places.at(1, 0, 1) = 0.25f;
    return run_pass({.pass = "surface_from_atlas",
                     .inputs = {{"atlas_uv", places},
                                {"atlas_albedo", constant({2, 1}, {0.25f, 0.5f, 1.0f})},
                                {"atlas_material", constant({2, 1}, {0.5f, 0.25f, 1.0f})},
                                {"atlas_emissive", constant({2, 1}, {2.0f, 3.0f, 4.0f})}}});
}

} // namespace

TEST_CASE("a pixel without a surface emits nothing, whatever the atlas's first texel does", "[passes][atlas]")
{
    const auto got = read_atlas();
    for (int c = 0; c < 3; ++c) {
        CHECK(got.at("emissive").at(0, 0, c) == 0.0f);
        CHECK(got.at("emissive").at(1, 0, c) == static_cast<float>(2 + c));
    }
}

TEST_CASE("albedo and material come from the place in the atlas", "[passes][atlas]")
{
    const auto got = read_atlas();
    const double tolerance = 8.0 * kRounding; // of a filter between equal texels
    CHECK(got.at("albedo").at(1, 0, 1) == Approx(0.5).margin(tolerance));
    CHECK(got.at("material").at(1, 0, 1) == Approx(0.25).margin(tolerance));
}
