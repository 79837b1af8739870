// Layouts in pass headers: places, targets, derivations, and each mistake in them.
#include <passgraph/core/pass_header.hpp>

#include "core_support.hpp"
#include "support/catch.hpp"

using namespace passgraph;
using namespace passgraph::test;

namespace {

std::string header(const std::string& layout)
{
    return R"(/*{ "pass": "own", "kind": "geometry",
"outputs": { "normal": "normal", "material": "material", "depth": "depth", "position": "position" },
"layouts": { "small": {
)" + layout + R"(
} } }*/)";
}

std::string codes(const std::string& layout)
{
    return codes_of(read_pass_header(header(layout), "own.glsl", "test", [](std::string_view) { return std::nullopt; }));
}

} // namespace

TEST_CASE("an output stands in channels of named targets, in a target of its own, or is derived", "[core][layout]")
{
    const PassDeclaration pass = read_pass(header(
        R"("targets": { "a": "rgba16", "b": "rgba8" }, "normal": "a.xy : octahedral_rg16", "material": "a.b, b.rg", "depth": "depth24",
           "position": "from place")"));
    const Layout& layout = pass.layouts.front();
    REQUIRE(layout.targets.size() == 3);
    CHECK(layout.targets[2].format == Format::depth24);
    CHECK(to_text(layout, *layout.find("normal")) == "a.rg : octahedral_rg16");
    CHECK(to_text(layout, *layout.find("material")) == "a.b, b.rg : rgba16");
    CHECK(to_text(layout, *layout.find("position")) == "from place");
}

TEST_CASE("each mistake of a layout is told at its place", "[core][layout]")
{
    CHECK(codes(R"("normals": "rgba8")") == "unknown_output 4:1\n");
    CHECK(codes(R"("normal": 7)") == "wrong_type 4:11\n");
    CHECK(codes(R"("normal": "rgba9")") == "unknown_codec 4:11\n");
    CHECK(codes(R"("targets": { "a": "rgba9" })") == "unknown_format 4:19\n");
    CHECK(codes(R"("normal": "b.xy : octahedral_rg16")") == "unknown_target 4:11\n");
    CHECK(codes(R"("targets": { "a": "rg16" }, "normal": "a.zw : octahedral_rg16")").starts_with("unknown_channels 4:39\n"));
    CHECK(codes(R"("targets": { "a": "rgba8" }, "normal": "a.xy : octahedral_rg16")") == "codec_mismatch 4:40\n");
    CHECK(codes(R"("targets": { "a": "rgba16" }, "normal": "a.x : octahedral_rg16")") == "channel_count 4:41\n");
    CHECK(codes(R"("targets": { "a": "rgba16" }, "normal": "a.xy : octahedral_rg16", "material": "a.yzw")") == "channel_taken 4:79\n");
    CHECK(codes(R"("targets": { "a": "rgba16" }, "normal": "rgba16f")") == "target_unused 3:14\n");
}

TEST_CASE("a derivation that is no pass, or cannot compute the output, is told when the graph is compiled", "[core][layout]")
{
    const auto compiled = [](const std::string& from) {
        PassLibrary library = builtin_passes();
        PassDeclaration pass = read_pass(R"(/*{ "pass": "own", "kind": "geometry", "outputs": { "depth": "depth", "position": "position" },
"layouts": { "small": { "depth": "depth32f", "position": "from )" + from + R"(" } } }*/)");
        library.add(std::make_shared<PassDeclaration>(pass));
        Graph graph(library);
        PassArguments arguments;
        arguments.inputs.push_back({"scene", graph.scene().elements});
        graph.output("place", graph.add("own", arguments)["position"]);
        return codes_of(compile(graph));
    };
    CHECK(compiled("position_from_depth") == "no error");
    CHECK(compiled("nowhere") == "unknown_pass 2:58\n");
    CHECK(compiled("vignette").find("unknown_output 2:58\n") == 0);
    CHECK(compiled("surface_from_atlas").find("input_missing 2:58\n") != std::string::npos);
}

TEST_CASE("only_where says where a pass does anything", "[core][layout]")
{
    const auto codes = [](const std::string& where) {
        return codes_of(read_pass_header(R"(/*{ "pass": "own", "inputs": { "image": "radiance", "depth": "depth" }, "outputs": { "color": "radiance" },
"only_where": )" + where + " }*/", "own.glsl", "test", [](std::string_view) { return std::nullopt; }));
    };
    CHECK(codes(R"("depth")") == "no error");
    CHECK(codes(R"({ "no_depth": "image" })") == "no error");
    CHECK(codes(R"("nowhere")") == "unknown_item 2:15\n");
    CHECK(codes(R"({ "no_depth": "picture" })") == "unknown_input 2:29\n");
    CHECK(codes(R"({ "no_depth": "depth" })") == "identity_mismatch 2:29\n");
}
