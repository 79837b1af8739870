// Every mistake a graph file can hold: its code and its place, all mistakes of a file in one go.
#include <fstream>

#include <passgraph/core/graph_file.hpp>

#include "core_support.hpp"
#include "support/catch.hpp"

using namespace passgraph;
using namespace passgraph::test;
using Catch::Contains;

namespace {

/// Reads, builds and compiles, as the program does.
Errors errors_of(const std::string& text)
{
    const auto description = read_graph_description(text, "g.json");
    if (!description)
        return description.error();
    const auto plan = compile(build_graph(*description, builtin_passes()));
    return plan ? Errors{} : plan.error();
}

/// A graph with a picture `photo` (radiance) and `code` (display), and these passes.
std::string graph_of(const std::string& passes, const std::string& rest = "\"outputs\": { \"color\": \"shown\" }")
{
    return "{ \"passgraph\": 1,\n  \"inputs\": { \"photo\": \"radiance\", \"code\": \"display\" },\n  \"passes\": {\n    " + passes + "\n  },\n  " + rest + "\n}\n";
}

const std::string kShown = R"("shown": { "pass": "tone_map", "inputs": { "image": "photo" } })";

struct Row {
    std::string text;
    std::vector<std::string> codes;
    std::string said; ///< part of the first mistake
};

void check(const std::vector<Row>& rows)
{
    for (const Row& row : rows) {
        const MarkedText source = marked(row.text);
        INFO(source.text);
        const Errors errors = errors_of(source.text);
        CHECK(codes_of(errors) == codes_at(source, row.codes));
        if (!errors.empty()) {
            CHECK_THAT(to_text(errors.front()), Contains(row.said));
            CHECK(errors.front().where.file == "g.json");
        }
    }
}

} // namespace

TEST_CASE("a right graph has no mistakes", "[core][graph]")
{
    CHECK(to_text(errors_of(graph_of(kShown))).empty());
}

TEST_CASE("a graph file's fields are known, present and of their type", "[core][graph]")
{
    check({
        {"@[]", {"wrong_type"}, "expected an object"},
        {"@{ \"passes\": {}, \"outputs\": {} }", {"field_missing"}, "passgraph"},
        {"@@{ \"passgraph\": 1 }", {"field_missing", "field_missing"}, "passes"},
        {"{ \"passgraph\": @2, \"passes\": {}, \"outputs\": {} }", {"version_unknown"}, "known is 1"},
        {graph_of(kShown, "@\"ouputs\": {}, \"outputs\": { \"color\": \"shown\" }"), {"unknown_field"}, "did you mean `outputs`?"},
        {graph_of(kShown, "\"outputs\": { \"color\": @5 }"), {"wrong_type"}, "expected a string"},
        {graph_of(kShown + ",\n \"more\": @7"), {"wrong_type"}, "pass `more`"},
        {graph_of("\"shown\": @{ \"inputs\": { \"image\": \"photo\" } }"), {"field_missing"}, "\"pass\""},
        {graph_of("\"shown\": { \"pass\": \"tone_map\", @\"input\": { \"image\": \"photo\" } }"), {"unknown_field"}, "did you mean `inputs`?"},
        {graph_of("\"shown\": { \"pass\": \"tone_map\", \"inputs\": { \"image\": @[\"photo\"] } }"), {"wrong_type"}, "input `image`"},
        {graph_of("\"shown\": { \"pass\": \"tone_map\", \"inputs\": { \"image\": \"photo\" }, \"scale\": @[1, 0] }"), {"wrong_type"}, "[1, 2] is half"},
        {graph_of("\"shown\": { \"pass\": \"tone_map\", \"inputs\": { \"image\": \"photo\" }, \"size\": @{} }"), {"field_missing"}, "\"of\""},
        {graph_of("\"shown\": { \"pass\": \"tone_map\", \"inputs\": { \"image\": \"photo\" }, \"params\": { \"white\": @null } }"), {"wrong_type"}, "a number"},
        {graph_of("\"shown\": { \"pass\": \"tone_map\", \"inputs\": { \"image\": \"photo\" }, \"params\": { \"white\": [1, @\"x\"] } }"), {"wrong_type"}, "a number"},
        {graph_of("\"shown\": { \"pass\": \"tone_map\", \"inputs\": { \"image\": \"photo\" }, \"static\": [@5] }"), {"wrong_type"}, "\"static\""},
        {graph_of(kShown, "\"params\": { \"x\": @7 }, \"outputs\": { \"color\": \"shown\" }"), {"wrong_type"}, "param `x`"},
    });
}

TEST_CASE("inputs say what their values mean", "[core][graph]")
{
    const auto input = [](const std::string& what) {
        return "{ \"passgraph\": 1, \"inputs\": { \"photo\": " + what + " }, \"passes\": { " + kShown + " }, \"outputs\": { \"color\": \"shown\" } }";
    };
    check({
        {input("@\"radience\""), {"unknown_signal"}, "did you mean `radiance`?"},
        {input("@{}"), {"field_missing"}, "\"signal\""},
        {input("@5"), {"wrong_type"}, "input `photo`"},
        {input("{ \"kind\": @\"scence\" }"), {"unknown_item"}, "did you mean `scene`?"},
        {input("{ \"signal\": \"radiance\", \"over\": @\"spere\" }"), {"unknown_item"}, "did you mean `sphere`?"},
        {input("{ \"signal\": \"radiance\", @\"kid\": \"image\" }"), {"unknown_field"}, "did you mean `kind`?"},
    });
}

TEST_CASE("names stand once and hold no dot", "[core][graph]")
{
    check({
        {graph_of(kShown + ",\n    @" + kShown), {"json_duplicate_key"}, "`shown` stands twice"},
        {graph_of(kShown + R"(, @"photo": { "pass": "bright", "inputs": { "image": "photo" } })"), {"duplicate_name"}, "one namespace"},
        {graph_of(kShown + R"(, @"a.b": { "pass": "bright", "inputs": { "image": "photo" } })"), {"name_malformed"}, "no dot"},
        {graph_of(kShown + R"(, @"": { "pass": "bright", "inputs": { "image": "photo" } })"), {"name_malformed"}, "not empty"},
    });
}

TEST_CASE("passes, ports, settings and codecs exist, and a near name is offered", "[core][graph]")
{
    const auto shown = [](const std::string& rest) { return graph_of(R"("shown": { "pass": "tone_map", "inputs": { "image": "photo" },)" "\n      " + rest + " }"); };
    check({
        {graph_of(R"("shown": { "pass": @"tonemap", "inputs": { "image": "photo" } })"), {"unknown_pass"}, "did you mean `tone_map`?"},
        {graph_of(R"("shown": { "pass": "tone_map", "inputs": { "image": "photo", @"imgae": "photo" } })"), {"unknown_input"}, "did you mean `image`?"},
        {shown(R"("params": { "exposrue": @2 })"), {"unknown_param"}, "did you mean `exposure`?"},
        {shown(R"("choices": { "bend": @"x" })"), {"unknown_param"}, "the settings are: exposure, white, curve, transfer"},
        {shown(R"("params": { "exposure": @"bright" })"), {"wrong_type"}, "expected a number"},
        {shown(R"("params": { "exposure": @[1, 2] })"), {"wrong_type"}, "got 2 numbers"},
        {shown(R"("params": { "exposure": @0 })"), {"param_out_of_range"}, "[0.01, 100]"},
        {shown(R"("params": { "exposure": @100.5, "white": @0.5 })"), {"param_out_of_range", "param_out_of_range"}, "shown.exposure = 100.5"},
        {shown(R"("static": ["exposure", @"whit"])"), {"unknown_param"}, "did you mean `white`?"},
        {shown(R"("codecs": { "color": @"rgba9" })"), {"unknown_codec"}, "did you mean `rgba8`?"},
        {shown(R"("codecs": { "colour": @"rgba8" })"), {"unknown_image"}, "did you mean `color`?"},
        {graph_of(R"("shown": { "pass": "vignette", "inputs": { "image": "code" }, "choices": { "shape": @"cirle" } })"), {"unknown_item"}, "did you mean `circle`?"},
        {graph_of(R"("shown": { "pass": "vignette", "inputs": { "image": "code" }, "choices": { "shape": @3 } })"), {"unknown_item"}, "ellipse, circle"},
        {shown(R"("size": { "of": @"fotos" })"), {"unknown_image"}, "there is no image `fotos`"},
    });
}

TEST_CASE("images exist, and a pass of several outputs must say which", "[core][graph]")
{
    const std::string surface = R"("surface": { "pass": "gbuffer", "inputs": { "scene": "scene" } },)";
    const auto scene_graph = [&](const std::string& pass) {
        return "{ \"passgraph\": 1, \"inputs\": { \"scene\": { \"kind\": \"scene\" } }, \"passes\": { " + surface + "\n  " + pass + " }, \"outputs\": { \"color\": \"shown\" } }";
    };
    check({
        {graph_of(R"("shown": { "pass": "tone_map", "inputs": { "image": @"phto" } })"), {"unknown_image"}, "did you mean `photo`?"},
        {graph_of(R"("shown": { "pass": "tone_map", "inputs": { "image": @"photo.color" } })"), {"unknown_image"}, "`photo` has no output `color`"},
        {graph_of(kShown, "\"outputs\": { \"color\": @\"shwon\" }"), {"unknown_image"}, "did you mean `shown`?"},
        {graph_of(kShown, "\"outputs\": { \"color\": @\"shown.colour\" }"), {"unknown_image"}, "did you mean `shown.color`?"},
        {scene_graph(R"("shown": { "pass": "tone_map", "inputs": { "image": @"surface" } })"), {"unknown_image"}, "`surface` has 7 outputs"},
        {scene_graph(R"("shown": { "pass": "tone_map", "inputs": { "image": @"surface.emisive" } })"), {"unknown_image"}, "did you mean `surface.emissive`?"},
        {scene_graph(R"("shown": { "pass": "tone_map", "inputs": { "image": @"scene" } })"), {"over_mismatch"}, "got a scene from scene"},
        {scene_graph(R"("shown": { "pass": "tone_map", "inputs": { "image": @"scene.sky" } })"), {"over_mismatch"}, "got a cube map from scene.sky"},
        {scene_graph(R"("shown": { "pass": "sky", "inputs": { "image": "surface.emissive", "depth": "surface.depth", "sky": @"scene" } })"),
         {"over_mismatch"}, "read scene.sky"},
    });
    CHECK(to_text(errors_of(scene_graph(R"("shown": { "pass": "sky", "inputs": { "image": "surface.emissive", "depth": "surface.depth", "sky": "scene.sky" } })"))).empty());
}

TEST_CASE("PASS and PASS.PORT name the same image", "[core][graph]")
{
    const auto json = [&](const std::string& name) {
        const auto description = read_graph_description(graph_of(kShown + R"(, "rim": { "pass": "vignette", "inputs": { "image": ")" + name + "\" } }",
                                                                 "\"outputs\": { \"color\": \"rim\" }"), "g.json");
        REQUIRE(description);
        return to_json(planned(build_graph(*description, builtin_passes())), true);
    };
    CHECK(json("shown") == json("shown.color"));
}

TEST_CASE("passes may stand in any order, but not wait for each other", "[core][graph]")
{
    CHECK(to_text(errors_of(graph_of(R"("shown": { "pass": "tone_map", "inputs": { "image": "b" } },
    "b": { "pass": "bright", "inputs": { "image": "a" } },
    "a": { "pass": "bright", "inputs": { "image": "photo" }, "size": { "of": "photo" } })"))).empty());
    check({
        {graph_of(R"("one": { "pass": "bright", "inputs": { "image": "two" } },
    "two": { "pass": "bright", "inputs": { "image": "three.color" } },
    "three": { "pass": "bright", "inputs": { "image": @"one" } },
    "shown": { "pass": "tone_map", "inputs": { "image": "three" } })"), {"cycle"}, "three -> two -> one -> three"},
        {graph_of(R"("shown": { "pass": "tone_map", "inputs": { "image": @"shown" } })"), {"cycle"}, "shown -> shown"},
        {graph_of(R"("shown": { "pass": "tone_map", "inputs": { "image": "photo" }, "size": { "of": @"shown" } })"), {"cycle"}, "shown -> shown"},
    });
}

TEST_CASE("the graph's own params lead to settings that exist", "[core][graph]")
{
    const auto params = [](const std::string& what) { return graph_of(kShown, "\"params\": { " + what + " }, \"outputs\": { \"color\": \"shown\" }"); };
    CHECK(to_text(errors_of(params(R"("light": ["shown.exposure", "shown.white"])"))).empty());
    check({
        {params(R"(@"light": "shown.exposrue")"), {"unknown_param"}, "did you mean `exposure`?"},
        {params(R"(@"light": "exposure")"), {"unknown_param"}, "PASS.NAME"},
        {params(R"(@"light": ["shown.exposure", "shown.white", "none.x"])"), {"unknown_param"}, "`none.x`"},
        {params(R"(@"one": "two", @"two": "one")"), {"unknown_param", "unknown_param"}, "param `one`"},
        {params(R"(@"self": "self")"), {"unknown_param"}, "param `self`"},
    });
}

TEST_CASE("a param of the graph sets each place it leads to", "[core][graph]")
{
    const auto description = read_graph_description(graph_of(R"("a": { "pass": "bright", "inputs": { "image": "photo" } },
    "b": { "pass": "bright", "inputs": { "image": "a" } }, "shown": { "pass": "tone_map", "inputs": { "image": "b" } })",
        R"("params": { "edge": ["a.threshold", "b.threshold"], "again": "edge" }, "outputs": { "color": "shown" })"), "g.json");
    REQUIRE(description);
    Graph graph = build_graph(*description, builtin_passes());
    CHECK(graph.places_of("edge") == std::vector<std::string>{"a.threshold", "b.threshold"});
    CHECK(graph.places_of("again") == graph.places_of("edge"));
    CHECK(graph.places_of("a.threshold") == std::vector<std::string>{"a.threshold"});
    CHECK(graph.places_of("nothing").empty());
    REQUIRE(graph.set("again", {"", {3.0}, "", {}}));
    for (const char* node : {"a", "b"})
        CHECK(graph.nodes()[static_cast<size_t>(graph.find_node(node))].params[0] == Value(3.0));
    const auto wrong = graph.set("edge", {"", {-1.0}, "", {}});
    REQUIRE(!wrong);
    CHECK(wrong.error().size() == 2); // at each place
    CHECK(codes_of(graph.set("egde", {"", {1.0}, "", {}})) == "unknown_param 0:0\n");
    CHECK(codes_of(graph.set_codec("shown", "rgba9")) == "unknown_codec 0:0\n");
    CHECK(codes_of(graph.set_codec("shwon", "rgba8")) == "unknown_image 0:0\n");
    REQUIRE(graph.set_codec("shown", "rgb10_a2"));
    CHECK(planned(graph).outputs.front().codec.name == "rgb10_a2");
}

TEST_CASE("a graph needs an output", "[core][graph]")
{
    const Errors errors = errors_of(graph_of(kShown, "\"outputs\": {}"));
    CHECK(codes_of(errors) == "output_missing 0:0\n");
}

TEST_CASE("a composite is a pass, not a graph", "[core][graph]")
{
    const auto composite = load_graph(PASSGRAPH_SOURCE_DIR "/passes/blur/gaussian_blur.graph.json", builtin_passes());
    REQUIRE(!composite);
    CHECK(composite.error().front().code == "composite_alone");
    CHECK(codes_of(load_graph("/nowhere.graph.json", builtin_passes())) == "file_missing 0:0\n");
}

TEST_CASE("all mistakes of a graph file come back at once, by their place", "[core][graph]")
{
    check({{graph_of(R"("film": { "pass": "bloom_combine", "inputs": { "scene": @"code", "bloom": "glow" } },
    "glow": { "pass": @"gausian_blur", "inputs": { "image": "photo" } },
    "dark": { "pass": @"bright" },
    "shown": { "pass": "tone_map", "inputs": { "image": "film", @"bloom": "film" }, "params": { "white": @0 } })",
                      R"("params": { @"size": "glow.sigma" }, "outputs": { "color": "shown", "other": @"nothing" })"),
            {"signal_mismatch", "unknown_pass", "input_missing", "unknown_input", "param_out_of_range", "unknown_param", "unknown_image"}, "film.scene"}});
}
