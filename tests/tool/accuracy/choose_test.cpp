// Which ladders a run measures, and what it says of those that it cannot.
#include <algorithm>

#include <passgraph/shader/pass_file.hpp>

#include "support/catch.hpp"
#include "support/test_context.hpp"
#include "tool/accuracy/choose.hpp"
#include "tool/accuracy/compared.hpp"

using namespace passgraph;
using namespace passgraph::accuracy;
using Catch::Contains;

namespace {

std::vector<std::string> names_of(const Ladders& ladders)
{
    std::vector<std::string> names;
    for (const auto& ladder : ladders)
        names.push_back(ladder->name);
    return names;
}

std::vector<std::string> chosen(const std::vector<std::string>& words, const PassLibrary& library)
{
    const auto ladders = choose_ladders(words, library);
    if (!ladders)
        FAIL(to_text(ladders.error()));
    return names_of(*ladders);
}

/// The built-in passes and one whose ladder is given: a box blur, of 3 or 5 texels, along one axis.
PassLibrary with_ladder(const std::string& ladder)
{
    PassLibrary library = builtin_passes();
    const auto pass = read_pass(R"(/*{ "pass": "own_blur", "summary": "Blurs.",
  "inputs": { "image": "radiance" }, "outputs": { "blurred": "radiance" },
  "params": { "sigma": { "type": "float", "default": 2, "range": [0, 20] } },
  "choices": { "direction": ["horizontal", "vertical"] },
  "ladders": { "width": )" + ladder + R"( } }*/
vec3 own_blur(vec2 uv)
{
    vec2 step = direction == direction_horizontal ? vec2(image_texel().x, 0.0) : vec2(0.0, image_texel().y);
#if width == width_3
    return (image(uv - step) + image(uv) + image(uv + step)) / 3.0 + 0.0 * sigma;
#else
    return (image(uv - 2.0 * step) + image(uv - step) + image(uv) + image(uv + step) + image(uv + 2.0 * step)) / 5.0 + 0.0 * sigma;
#endif
}
)",
                                "own_blur.glsl", "own", {});
    if (!pass)
        FAIL(to_text(pass.error()));
    library.add(*pass);
    return library;
}

Error only_error(const std::vector<std::string>& words, const PassLibrary& library)
{
    const auto ladders = choose_ladders(words, library);
    REQUIRE_FALSE(ladders);
    REQUIRE(ladders.error().size() == 1);
    return ladders.error().front();
}

} // namespace

TEST_CASE("a pass's name chooses the ladders that concern it, a ladder's name itself, nothing all", "[accuracy][choose]")
{
    CHECK(chosen({"tone_map"}, builtin_passes()) == std::vector<std::string>{"tone_curve", "srgb_transfer"});
    CHECK(chosen({"guards"}, builtin_passes()) == std::vector<std::string>{"guards"});
    CHECK(chosen({"gaussian_blur", "blur"}, builtin_passes()) == std::vector<std::string>{"blur"});
    CHECK(chosen({}, builtin_passes()).size() == all_ladders().size());
}

TEST_CASE("a name that is none, and a pass without ladders, are errors with a hint", "[accuracy][choose]")
{
    const Error unknown = only_error({"tone_mapp"}, builtin_passes());
    CHECK(unknown.code == "unknown_pass");
    CHECK_THAT(unknown.hint, Contains("tone_map"));
    const Error missing = only_error({"night_vision"}, builtin_passes());
    CHECK(missing.code == "ladder_missing");
    CHECK_THAT(missing.hint, Contains("normal_codec"));
}

TEST_CASE("a ladder without a reference is an error at its line, whether asked for or among all", "[accuracy][choose]")
{
    const PassLibrary library = with_ladder(R"(["3", "5"])");
    for (const std::vector<std::string>& words : {std::vector<std::string>{"own_blur"}, std::vector<std::string>{}}) {
        const Error error = only_error(words, library);
        CHECK(error.code == "ladder_without_reference");
        CHECK(error.where.file == "own_blur.glsl");
        CHECK(error.where.line == 5);
        CHECK_THAT(error.hint, Contains("gaussian") && Contains("\"reference\""));
    }
}

TEST_CASE("a reference that is none, or that does not fit the pass, is an error at its line", "[accuracy][choose]")
{
    const Error unknown = only_error({"own_blur"}, with_ladder(R"({ "items": ["3", "5"], "reference": "gausian" })"));
    CHECK(unknown.code == "unknown_reference");
    CHECK(unknown.where.line == 5);
    PassLibrary library = builtin_passes();
    const auto pass = read_pass(R"(/*{ "pass": "sum", "inputs": { "one": "radiance", "two": "radiance" }, "outputs": { "both": "radiance" },
  "ladders": { "share": { "items": ["none", "all"], "reference": "gaussian" } } }*/
vec3 sum(vec2 uv) { return one(uv) + two(uv) * float(share); }
)",
                                "sum.glsl", "own", {});
    if (!pass)
        FAIL(to_text(pass.error()));
    library.add(*pass);
    const Error mismatch = only_error({"sum"}, library);
    CHECK(mismatch.code == "reference_mismatch");
    CHECK(mismatch.where.line == 2);
    CHECK_THAT(mismatch.hint, Contains("sigma"));
}

TEST_CASE("a user's ladder that names a reference is drawn and compared, item by item", "[accuracy][choose]")
{
    const PassLibrary library = with_ladder(R"({ "items": ["3", "5"], "default": "5", "reference": "gaussian" })");
    const auto ladders = choose_ladders({"own_blur"}, library);
    REQUIRE(ladders);
    REQUIRE(ladders->size() == 1);
    const Ladder& ladder = *ladders->front();
    CHECK(ladder.name == "own_blur.width");
    REQUIRE(ladder.rungs.size() == 2);
    CHECK(ladder.rungs[1].is_default);
    const Extent extent{144, 144};
    const Inputs inputs = ladder.make_inputs(extent);
    const Truth truth = ladder.find_truth(inputs, extent);
    // A box of n texels has a variance of (n^2 - 1) / 12: a sigma of 0.8165 for 3 and of 1.4142 for 5, along both axes.
    const double expected[] = {std::sqrt(8.0 / 12.0), std::sqrt(2.0)};
    for (size_t i = 0; i < 2; ++i) {
        const auto result = compare_rung(ladder, ladder.rungs[i], inputs, truth, library, test::test_context().loader());
        if (!result)
            FAIL(to_text(result.error()));
        CHECK(test::figure_of(result->rung, "realised sigma") == Approx(expected[i]).epsilon(1e-5));
    }
}
