// Composites: graphs with ports, declared like a pass and expanded where they are used.
#include <set>

#include <passgraph/core/graph_file.hpp>

#include "core_support.hpp"
#include "support/catch.hpp"

using namespace passgraph;
using namespace passgraph::test;
using Catch::Contains;

namespace {

Result<PassPtr> declared(const std::string& text, const PassLibrary& library)
{
    const auto description = read_graph_description(text, "c.graph.json");
    if (!description)
        return tl::unexpected(description.error());
    return declare_composite(std::make_shared<const GraphDescription>(*description), "test", library);
}

PassLibrary library_with(const std::vector<std::string>& composites)
{
    PassLibrary library = builtin_passes();
    for (const std::string& text : composites) {
        const auto pass = declared(text, library);
        if (!pass)
            FAIL(to_text(pass.error()));
        library.add(*pass);
    }
    return library;
}

Graph built(const std::string& text, const PassLibrary& library)
{
    const auto description = read_graph_description(text, "g.json");
    if (!description)
        FAIL(to_text(description.error()));
    return build_graph(*description, library);
}

std::string glow_graph(const std::string& rest, const std::string& end = "")
{
    return R"({ "passgraph": 1, "inputs": { "photo": "radiance" }, "passes": {
  "glow": { "pass": "gaussian_blur", "inputs": { "image": "photo" })" + rest + R"( } },
  "outputs": { "color": "glow" })" + end + " }";
}

const GraphNode& node(const Graph& graph, const std::string& name)
{
    INFO(name);
    REQUIRE(graph.find_node(name) >= 0);
    return graph.nodes()[static_cast<size_t>(graph.find_node(name))];
}

const std::string kTwice = R"({ "passgraph": 1, "pass": "blur_twice", "inputs": { "image": "color" }, "passes": {
  "first": { "pass": "gaussian_blur", "inputs": { "image": "image" }, "params": { "sigma": 1.5 } },
  "second": { "pass": "gaussian_blur", "inputs": { "image": "first" } } },
  "params": { "size": ["first.sigma", "second.sigma"], "taps": "second.taps" }, "outputs": { "color": "second" } })";

} // namespace

TEST_CASE("a composite expands to its passes, named outer.inner", "[core][composite]")
{
    const Graph graph = built(glow_graph(""), builtin_passes());
    REQUIRE(graph.nodes().size() == 3);
    CHECK(graph.nodes()[1].name == "glow.horizontal");
    CHECK(graph.nodes()[2].name == "glow.vertical");
    CHECK(graph.nodes()[1].inputs[0]->from == ImageRef{0, 0});
    CHECK(graph.nodes()[2].inputs[0]->from == ImageRef{1, 0});
    CHECK(graph.find_image("glow") == ImageRef{2, 0});
    CHECK(graph.find_image("glow.blurred") == ImageRef{2, 0});
    CHECK(graph.find_image("glow.horizontal") == ImageRef{1, 0}); // a look inside
    CHECK(planned(graph).steps.size() == 2);
}

TEST_CASE("settings, statics and codecs of a composite reach the passes inside", "[core][composite]")
{
    const Graph graph = built(glow_graph(R"(, "params": { "sigma": 3 }, "rungs": { "taps": "25" }, "static": ["sigma"], "codecs": { "blurred": "rgba32f" })"),
                              builtin_passes());
    for (const char* name : {"glow.horizontal", "glow.vertical"}) {
        CHECK(node(graph, name).params[0] == Value(3.0));
        CHECK(node(graph, name).is_static[0]);
        CHECK(node(graph, name).selections[static_cast<size_t>(node(graph, name).pass->find_selection("taps"))] == 3);
    }
    CHECK(node(graph, "glow.horizontal").codecs[0].empty());
    CHECK(node(graph, "glow.vertical").codecs[0] == "rgba32f");
}

TEST_CASE("a composite's settings stay settable from outside", "[core][composite]")
{
    Graph graph = built(glow_graph("", R"(, "params": { "size": "glow.sigma" })"), builtin_passes());
    CHECK(graph.places_of("glow.sigma") == std::vector<std::string>{"glow.horizontal.sigma", "glow.vertical.sigma"});
    REQUIRE(graph.set("glow.sigma", {"", {4.0}, "", {}}));
    CHECK(node(graph, "glow.vertical").params[0] == Value(4.0));
    REQUIRE(graph.set("size", {"", {5.0}, "", {}}));
    CHECK(node(graph, "glow.horizontal").params[0] == Value(5.0));
    REQUIRE(graph.set("glow.vertical.sigma", {"", {6.0}, "", {}}));
    CHECK(node(graph, "glow.horizontal").params[0] == Value(5.0));
    CHECK(node(graph, "glow.vertical").params[0] == Value(6.0));
    CHECK(codes_of(graph.set("glow.sgima", {"", {1.0}, "", {}})) == "unknown_param 0:0\n");
    REQUIRE(graph.set_codec("glow", "r11f_g11f_b10f"));
    CHECK(planned(graph).outputs.front().codec.name == "r11f_g11f_b10f");
}

TEST_CASE("a composite declares what it routes, with the values it has inside", "[core][composite]")
{
    const auto pass = declared(kTwice, builtin_passes());
    REQUIRE(pass);
    CHECK((*pass)->name == "blur_twice");
    CHECK((*pass)->inputs.front().signal == Signal::color);
    CHECK((*pass)->outputs.front().signal == Signal::color);
    REQUIRE((*pass)->params.size() == 1);
    CHECK((*pass)->params[0].name == "size");
    CHECK((*pass)->params[0].default_value == Value(1.5)); // of the first place
    CHECK((*pass)->params[0].highest == 20.0);
    REQUIRE((*pass)->selections.size() == 1);
    CHECK((*pass)->selections[0].items.size() == 5);
}

TEST_CASE("composites nest", "[core][composite]")
{
    const PassLibrary library = library_with({kTwice});
    Graph graph = built(R"({ "passgraph": 1, "inputs": { "photo": "display" }, "passes": {
  "soft": { "pass": "blur_twice", "inputs": { "image": "photo" }, "params": { "size": 7 } } }, "outputs": { "color": "soft" } })", library);
    CHECK(planned(graph).steps.size() == 4);
    CHECK(planned(graph).outputs.front().signal == Signal::display);
    for (const char* name : {"soft.first.horizontal", "soft.first.vertical", "soft.second.horizontal", "soft.second.vertical"})
        CHECK(node(graph, name).params[0] == Value(7.0));
    REQUIRE(graph.set("soft.size", {"", {2.0}, "", {}}));
    CHECK(node(graph, "soft.first.vertical").params[0] == Value(2.0));
}

TEST_CASE("a composite hands a scene and its sky inwards", "[core][composite]")
{
    const PassLibrary library = library_with({R"({ "passgraph": 1, "pass": "whole", "inputs": { "world": { "kind": "scene" } }, "passes": {
  "surface": { "pass": "gbuffer", "inputs": { "scene": "world" } },
  "view": { "pass": "sky", "inputs": { "image": "surface.emissive", "depth": "surface.depth", "sky": "world.sky" } } }, "outputs": { "color": "view" } })"});
    CHECK(library.find("whole")->inputs.front().over == Over::scene);
    const Graph graph = built(R"({ "passgraph": 1, "inputs": { "scene": { "kind": "scene" } }, "passes": {
  "all": { "pass": "whole", "inputs": { "world": "scene" } } }, "outputs": { "color": "all" } })", library);
    const Plan plan = planned(graph);
    // The G-buffer's default layout reads emission from the scene's atlas.
    std::set<std::string> imports;
    for (const Plan::Import& import : plan.imports)
        imports.insert(import.name);
    CHECK(imports == std::set<std::string>{"scene.sky", "scene.atlas_albedo", "scene.atlas_material", "scene.atlas_emissive"});
    const Graph wrong = built(R"({ "passgraph": 1, "inputs": { "photo": "radiance" }, "passes": {
  "all": { "pass": "whole", "inputs": { "world": "photo" } } }, "outputs": { "color": "all" } })", library);
    CHECK(codes_of(compile(wrong)) == "over_mismatch 2:50\nover_mismatch 2:50\n"); // as scene, and as sky
}

TEST_CASE("wrong uses of a composite are located in the file that uses it", "[core][composite]")
{
    const auto check = [](const std::string& rest, const std::vector<std::string>& codes, const std::string& said) {
        const MarkedText source = marked(glow_graph(rest));
        INFO(source.text);
        const auto plan = compile(built(source.text, builtin_passes()));
        CHECK(codes_of(plan) == codes_at(source, codes));
        if (!plan)
            CHECK_THAT(to_text(plan.error()), Contains(said) && Contains("g.json:"));
    };
    check(R"(, "params": { "sgima": @3 })", {"unknown_param"}, "did you mean `sigma`?");
    check(R"(, "params": { "sigma": @21 })", {"param_out_of_range"}, "glow.sigma = 21");
    check(R"(, "params": { "sigma": @"x" })", {"wrong_type"}, "expected a number");
    check(R"(, "rungs": { "taps": @7 })", {"unknown_item"}, "glow.taps cannot be `7`");
    check(R"(, "static": [@"sgima"])", {"unknown_param"}, "did you mean `sigma`?");
    check(R"(, "codecs": { "blured": @"rgba16f" })", {"unknown_image"}, "did you mean `blurred`?");
}

TEST_CASE("a composite is not scaled, and its ports are wired by their names", "[core][composite]")
{
    const auto scaled = compile(built(glow_graph(R"(, "scale": [1, 2])"), builtin_passes()));
    CHECK(codes_of(scaled) == "scale_on_composite 2:21\n");
    const auto stored = compile(built(glow_graph(R"(, "codecs": { "blurred": "rgba8" })"), builtin_passes()));
    CHECK(codes_of(stored) == "unknown_codec 2:21\n"); // known only once the signal is: a mistake of the use all the same
    CHECK(stored.error().front().where.file == "g.json");
    const auto wrong = compile(built(R"({ "passgraph": 1, "inputs": { "photo": "radiance" }, "passes": {
  "glow": { "pass": "gaussian_blur", "inputs": { "imag": "photo" } } }, "outputs": { "color": "glow" } })", builtin_passes()));
    CHECK(codes_of(wrong) == "input_missing 2:21\nunknown_input 2:50\n");
    const auto mismatch = compile(built(R"({ "passgraph": 1, "inputs": { "normals": "normal" }, "passes": {
  "glow": { "pass": "gaussian_blur", "inputs": { "image": "normals" } } }, "outputs": { "color": "glow" } })", builtin_passes()));
    REQUIRE(!mismatch);
    CHECK_THAT(to_text(mismatch.error()), Contains("g.json:2:") && Contains("glow.horizontal.image: expects color, got normal from normals"));
}

TEST_CASE("a composite that is wrong inside is not declared", "[core][composite]")
{
    const auto code_of = [](const std::string& passes, const std::string& outputs, const std::string& name = R"("pass": "own", )") {
        return codes_of(declared("{ \"passgraph\": 1, " + name + R"("inputs": { "image": "color" }, "passes": { )" + passes + " },\n \"outputs\": { \"color\": \"" + outputs + "\" } }",
                                 builtin_passes()));
    };
    const std::string soft = R"("soft": { "pass": "gaussian_blur", "inputs": { "image": "image" } })";
    CHECK(code_of(soft, "soft") == "no error");
    CHECK(code_of(soft, "sfot") == "unknown_image 2:24\n");
    CHECK(code_of(soft, "soft", "") == "not_a_composite 1:1\n");
    CHECK_THAT(code_of(R"("soft": { "pass": "gausian_blur", "inputs": { "image": "image" } })", "soft"), Contains("unknown_pass 1:"));
    CHECK(code_of(R"("soft": { "pass": "own", "inputs": { "image": "image" } })", "soft") == "cycle 1:1\n");
}

TEST_CASE("a composite that stands in for a pass it is made of would never end", "[core][composite]")
{
    // blur_twice is made of gaussian_blur, so a gaussian_blur made of blur_twice is made of itself.
    const PassLibrary library = library_with({kTwice});
    const auto pass = declared(R"({ "passgraph": 1, "pass": "gaussian_blur", "inputs": { "image": "color" }, "passes": {
  "soft": { "pass": "blur_twice", "inputs": { "image": "image" } } }, "outputs": { "blurred": "soft" } })", library);
    REQUIRE(!pass);
    CHECK(pass.error().front().code == "cycle");
}

TEST_CASE("a composite may hand an input straight through", "[core][composite]")
{
    const PassLibrary library = library_with({R"({ "passgraph": 1, "pass": "through", "inputs": { "image": "radiance" }, "passes": {}, "outputs": { "color": "image" } })"});
    const Graph graph = built(R"({ "passgraph": 1, "inputs": { "photo": "radiance" }, "passes": {
  "same": { "pass": "through", "inputs": { "image": "photo" }, "codecs": { "color": "rgba16f" } } }, "outputs": { "color": "same" } })", library);
    const Plan plan = planned(graph);
    CHECK(plan.steps.empty());
    CHECK(plan.outputs.front().source == Plan::Read::Source::import);
}

TEST_CASE("an optional input of a composite may stay unwired, and its readers do without", "[core][composite]")
{
    const PassLibrary library = builtin_passes();
    const std::string head = R"({ "passgraph": 1, "inputs": { "a": "albedo", "m": "material", "n": "normal", "p": "position", "e": "radiance" },
  "passes": { "lit": { "pass": "pbr", "inputs": { "albedo": "a", "material": "m", "normal": "n", "position": "p")";
    const std::string tail = R"( } } }, "outputs": { "color": "lit" } })";
    const Plan bare = planned(built(head + tail, library));
    CHECK(bare.imports.size() == 4);
    const Plan glowing = planned(built(head + R"(, "emissive": "e")" + tail, library));
    CHECK(glowing.imports.size() == 5);
    const PassPtr pbr = library.find("pbr");
    CHECK(pbr->inputs[static_cast<size_t>(pbr->find_input("sky"))].is_optional);
    CHECK_FALSE(pbr->inputs[static_cast<size_t>(pbr->find_input("albedo"))].is_optional);
    // A graph that is no composite has nobody to leave an input out.
    const auto graph = read_graph_description(R"({ "passgraph": 1, "inputs": { "a": { "signal": "radiance", "optional": true } },
  "passes": { "b": { "pass": "bright", "inputs": { "image": "a" } } }, "outputs": { "color": "b" } })", "g.json");
    REQUIRE_FALSE(graph);
    CHECK(graph.error().front().code == "optional_unused");
}

TEST_CASE("a live parameter inside a composite is known by the composite's own name", "[core][composite]")
{
    const PassLibrary library = library_with({R"({ "passgraph": 1, "pass": "lifted", "inputs": { "image": "radiance" }, "passes": {
  "inner": { "pass": "bright", "inputs": { "image": "image" } } },
  "params": { "level": "inner.threshold" }, "outputs": { "color": "inner" } })"});
    const Plan plan = planned(built(R"({ "passgraph": 1, "inputs": { "photo": "radiance" }, "passes": {
  "all": { "pass": "lifted", "inputs": { "image": "photo" } } }, "outputs": { "color": "all" } })", library));
    std::set<std::string> names;
    for (const Plan::Uniform& uniform : plan.steps.front().uniforms)
        names.insert(uniform.place);
    CHECK(names == std::set<std::string>{"all.level", "all.inner.knee"});
}
