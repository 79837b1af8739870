// What a rung may decide beside the code: how an input is filtered; and stores without their guards.
#include <passgraph/core/pass_header.hpp>

#include "core_support.hpp"
#include "support/catch.hpp"

using namespace passgraph;
using namespace passgraph::test;
using Catch::Contains;

namespace {

std::string pass_with(const std::string& filter)
{
    return R"(/*{ "pass": "own", "inputs": { "image": { "signal": "radiance", "filter": )" + filter + R"( } }, "outputs": { "color": "radiance" },
  "ladders": { "sampling": { "items": ["pairs", "nearest"], "default": "nearest", "reference": "gaussian" } } }*/
vec3 own(vec2 uv) { return image(uv + image_texel()); }
)";
}

Plan plan_of(const PassLibrary& library, const std::string& rung, const CompileOptions& options = {})
{
    Graph graph(library);
    PassArguments arguments;
    arguments.inputs.push_back({"image", graph.picture("photo", Signal::radiance)});
    arguments.settings.push_back({"sampling", {}, rung, {}});
    graph.output("color", graph.add("own", arguments)[""]);
    return planned(graph, options);
}

PassLibrary library_of_own()
{
    PassLibrary library;
    library.add(std::make_shared<const PassDeclaration>(read_pass(pass_with(R"({ "sampling": { "pairs": "linear" } })"))));
    return library;
}

Errors errors_of(const std::string& text)
{
    const auto pass = read_pass_header(text, "p.glsl", "test", [](std::string_view) { return std::nullopt; });
    return pass ? Errors{} : pass.error();
}

} // namespace

TEST_CASE("a rung decides how an input is filtered", "[core][pass]")
{
    const PassLibrary library = library_of_own();
    CHECK(plan_of(library, "pairs").steps.front().reads.front().filter == Filter::linear);
    CHECK(plan_of(library, "nearest").steps.front().reads.front().filter == Filter::nearest);
}

TEST_CASE("a filter by rungs names a ladder or choice, its items, and words that exist", "[core][pass]")
{
    const std::pair<const char*, const char*> rows[] = {
        {R"({ "samplng": { "pairs": "linear" } })", "did you mean `sampling`?"},
        {R"({ "sampling": { "pair": "linear" } })", "did you mean `pairs`?"},
        {R"({ "sampling": { "pairs": "liner" } })", "did you mean `linear`?"},
    };
    for (const auto& [filter, hint] : rows) {
        const Errors errors = errors_of(pass_with(filter));
        REQUIRE(errors.size() == 1);
        CHECK(errors.front().code == "unknown_item");
        CHECK(errors.front().where.line == 1);
        CHECK_THAT(errors.front().hint, Contains(hint));
    }
    for (const char* filter : {R"({ "sampling": "linear" })", R"({})", R"({ "sampling": {}, "other": {} })"}) {
        const Errors errors = errors_of(pass_with(filter));
        REQUIRE(errors.size() == 1);
        CHECK(errors.front().code == "wrong_type");
    }
}

TEST_CASE("a ladder may name its reference, a choice has none", "[core][pass]")
{
    CHECK(read_pass(pass_with("\"nearest\"")).selections.front().reference == "gaussian");
    const Errors errors = errors_of(R"(/*{ "pass": "own", "inputs": { "image": "radiance" }, "outputs": { "color": "radiance" },
  "choices": { "shape": { "items": ["round"], "reference": "gaussian" } } }*/
vec3 own(vec2 uv) { return image(uv); }
)");
    REQUIRE(errors.size() == 1);
    CHECK(errors.front().code == "unknown_field");
}

TEST_CASE("without guards a step stores what its pass returns, and still guards what a host supplies", "[core][glsl]")
{
    const PassLibrary library = library_of_own();
    const std::string guarded = plan_of(library, "nearest").steps.front().fragment;
    const std::string bare = plan_of(library, "nearest", {.guards = false}).steps.front().fragment;
    CHECK_THAT(guarded, Contains("v0_color = passgraph_guard_zero_to_cap(p0_own(uv), 65504.0);"));
    CHECK_THAT(bare, Contains("v0_color = p0_own(uv);"));
    CHECK_THAT(bare, Contains("return passgraph_guard_zero_to_cap(texture("));
}

TEST_CASE("octahedral codes of 10 bits are whole numbers before they are stored", "[core][glsl]")
{
    const Codec* codec = find_codec(Signal::normal, "octahedral_rg10");
    REQUIRE(codec);
    CHECK(codec->format == Format::rgb10_a2);
    CHECK_THAT(glsl_encode_call(Signal::normal, *codec, "n"), Contains("passgraph_octahedral_encode_10(n)"));
    CHECK_THAT(glsl_decode_call(Signal::normal, *codec, "t"), Contains("1023.0"));
    // Code 512 is exactly 0: both axes in the middle are +Z.
    Picture raw({1, 1}, 4);
    raw.texels = {512.0f / 1023.0f, 512.0f / 1023.0f, 0.0f, 1.0f};
    const Picture normal = decode_texels(raw, Signal::normal, *codec);
    CHECK(normal.texels == std::vector<float>{0.0f, 0.0f, 1.0f});
}
