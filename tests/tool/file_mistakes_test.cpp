// Missing, truncated and malformed files of every kind: named, exit code 1, and no output file touched.
#include <fstream>
#include <iterator>

#include "program.hpp"
#include "support/catch.hpp"

using namespace passgraph;
using test::Workplace;
using Catch::Contains;

namespace {

std::string data_file(const std::string& name)
{
    std::ifstream file(std::string(PASSGRAPH_SOURCE_DIR) + "/tests/data/" + name, std::ios::binary);
    REQUIRE(file);
    return {std::istreambuf_iterator<char>(file), {}};
}

constexpr const char* kSceneGraph = R"({ "passgraph": 1, "inputs": { "scene": { "kind": "scene" } },
  "passes": { "surface": { "pass": "gbuffer", "inputs": { "scene": "scene" } } },
  "outputs": { "normal": "surface.normal" } })";

std::string scene_of(const std::string& model)
{
    return "{ \"passgraph_scene\": 1,\n  \"elements\": [ { \"model\": \"" + model + "\" } ] }\n";
}

/// The errors of drawing `s.scene.json`; an old output file must stay as it was.
std::string scene_errors(const Workplace& place)
{
    place.write("g.graph.json", kSceneGraph);
    place.write("old.exr", "untouched");
    const auto files = place.files();
    const test::Outcome outcome =
        place.run({"render", "g.graph.json", "--scene", "s.scene.json", "--size", "16x16", "--out", "normal=old.exr"});
    CHECK(outcome.code == 1);
    CHECK(outcome.out.empty());
    CHECK(place.files() == files);
    CHECK(place.read("old.exr") == "untouched");
    return outcome.err;
}

} // namespace

TEST_CASE("a missing file of any kind is named", "[tool][files]")
{
    const Workplace place;
    place.write("g.graph.json", test::tone_map_graph());
    const std::vector<std::vector<std::string>> missing = {
        {"check", "none.x"},
        {"plan", "none.x"},
        {"render", "none.x", "--out", "color=a.png"},
        {"bench", "none.x"},
        {"plan", "g.graph.json", "--scene", "none.x"},
        {"plan", "g.graph.json", "--passes", "none.x"},
        {"render", "g.graph.json", "--in", "image=none.x.png", "--out", "color=a.png"},
        {"describe", "none.x.glsl"},
        {"run", "none.x.glsl", "--out", "color=a.png"},
        {"eval", "x", "--csv", "none.x"},
        {"eval", "x", "--csv", "none.x", "--include", "other.x"},
    };
    for (const auto& words : missing) {
        INFO(words[0] << " " << words[1]);
        const test::Outcome outcome = place.run(words);
        CHECK(outcome.code == 1);
        CHECK_THAT(outcome.err, Contains("error[file_missing]") && Contains("none.x"));
    }
    CHECK(place.files() == std::vector<std::string>{"g.graph.json"});
}

TEST_CASE("a picture that is broken off or none at all is refused", "[tool][files]")
{
    const Workplace place;
    place.write("g.graph.json", test::tone_map_graph());
    place.write_picture("whole.png", test::flat({40, 40}, {0.25f, 0.5f, 0.75f}));
    const std::string whole = place.read("whole.png");
    place.write("half.png", whole.substr(0, whole.size() / 2));
    place.write("text.exr", "not a picture");
    for (const char* file : {"half.png", "text.exr"}) {
        const test::Outcome outcome = place.run({"render", "g.graph.json", "--in", std::string("image=") + file, "--out", "color=a.png"});
        INFO(file);
        CHECK(outcome.code == 1);
        CHECK_THAT(outcome.err, Contains("error[picture_malformed]") && Contains(file));
    }
    CHECK_FALSE(place.has("a.png"));
}

TEST_CASE("a scene's mistakes come all at once, with their places", "[tool][files]")
{
    const Workplace place;
    place.write("s.scene.json", "{ \"passgraph_scene\": 1,\n  \"lights\": [ { \"kind\": \"spot\" } ],\n  \"elements\": 3,\n  \"camra\": {} }\n");
    CHECK_THAT(scene_errors(place), Contains("s.scene.json:2:") && Contains("s.scene.json:3:") && Contains("s.scene.json:4:") &&
                                        Contains("did you mean `camera`?"));
    place.write("s.scene.json", "{ \"passgraph_scene\": 1, \"elements\": [");
    CHECK_THAT(scene_errors(place), Contains("error[json_syntax]"));
}

TEST_CASE("a glTF that is missing, broken off or points outside is refused", "[tool][files]")
{
    const Workplace place;
    place.write("s.scene.json", scene_of("none.glb"));
    CHECK_THAT(scene_errors(place), Contains("error[file_missing]") && Contains("none.glb"));
    for (const char* name : {"index_past_vertices.gltf", "view_past_buffer.gltf", "truncated.glb", "truncated.gltf", "node_cycle.gltf"}) {
        INFO(name);
        place.write(name, data_file(std::string("malformed/") + name));
        place.write("s.scene.json", scene_of(name));
        CHECK_THAT(scene_errors(place), Contains("error[") && Contains(name));
    }
}

TEST_CASE("a graph that draws a scene asks for one", "[tool][files]")
{
    const Workplace place;
    place.write("g.graph.json", kSceneGraph);
    const test::Outcome outcome = place.run({"render", "g.graph.json", "--out", "normal=a.exr"});
    CHECK(outcome.code == 1);
    CHECK_THAT(outcome.err, Contains("error[scene_missing]") && Contains("--scene"));
}

TEST_CASE("a pass file's mistakes have the file's own lines", "[tool][files]")
{
    const Workplace place;
    place.write("own/dim.glsl", "/*{ \"pass\": \"dim\",\n  \"inputs\": { \"image\": \"radiance\" },\n  \"outputs\": { \"color\": \"radiance\" } }*/\n"
                                "vec3 dim(vec2 uv)\n{\n    return image(uv) * strenght;\n}\n");
    const test::Outcome described = place.run({"describe", "own/dim.glsl"});
    CHECK(described.code == 1);
    CHECK_THAT(described.err, Contains("own/dim.glsl:6:") && Contains("strenght"));
    // In a folder of passes it is found as well, and by every command.
    place.write("g.graph.json", test::tone_map_graph());
    const test::Outcome planned = place.run({"plan", "g.graph.json", "--passes", "own"});
    CHECK(planned.code == 1);
    CHECK_THAT(planned.err, Contains("dim.glsl:6:"));
    place.write("own/dim.glsl", "/*{ \"pass\": \"dim\", \"inputs\": {");
    CHECK(place.run({"describe", "own/dim.glsl"}).code == 1);
}
