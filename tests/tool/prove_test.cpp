// `passgraph facts` and `passgraph prove`.
#include "support/catch.hpp"
#include "tool/program.hpp"
#include "tool/schema.hpp"

using namespace passgraph;
using test::Workplace;
using Catch::Contains;

namespace {

const std::string kModels = std::string(PASSGRAPH_SOURCE_DIR) + "/tests/data/models/";

/// Bloom over a picture, the prefilter being a pass of the user's own.
std::string bloom_graph(const std::string& prefilter)
{
    return R"({ "passgraph": 1, "inputs": { "image": "radiance" }, "passes": {
      "bright": { "pass": ")" + prefilter + R"(", "inputs": { "image": "image" } },
      "half":   { "pass": "downsample", "inputs": { "image": "bright" } },
      "film":   { "pass": "bloom_combine", "inputs": { "scene": "image", "bloom": "half" } },
      "shown":  { "pass": "tone_map", "inputs": { "image": "film" } } },
    "outputs": { "color": "shown" } })";
}

/// Keeps what is above 0.4; `when` and `more` are what its header claims.
std::string prefilter(const std::string& when, const std::string& more = "")
{
    return R"(/*{ "pass": "own_bright", "inputs": { "image": "radiance" }, "outputs": { "color": "radiance" },
  "black": ["image"], "skip": { "when": ")" + when + R"(", "value": 0 })" + more + R"( }*/
vec3 own_bright(vec2 uv) { vec3 seen = image(uv); return seen * step(0.4, seen.g); }
)";
}

} // namespace

TEST_CASE("facts are upper bounds, and lamps say what they reach", "[tool][facts]")
{
    const Workplace place;
    place.write("s.scene.json", R"({ "passgraph_scene": 1, "elements": [ { "model": ")" + kModels + R"(box01.glb" } ], "lights": [
      { "name": "sun", "kind": "directional", "color": [1, 1, 1], "direction": [0, -1, 0] },
      { "name": "far", "kind": "point", "color": [1, 1, 1], "position": [0, 900, 0], "radius": 2 },
      { "name": "off", "kind": "spot", "color": [0, 0, 0], "position": [0, 3, 0], "radius": 20, "direction": [0, -1, 0],
        "inner_angle_degrees": 10, "outer_angle_degrees": 20 } ] })");
    const auto text = place.run({"facts", "s.scene.json"});
    CHECK(text.err == "");
    CHECK(text.code == 0);
    CHECK_THAT(text.out, Contains("far                 point       reaches no surface"));
    CHECK_THAT(text.out, Contains("off                 spot        is off"));
    const Json json = test::json_of(place.run({"facts", "s.scene.json", "--json"}).out);
    CHECK(test::find_schema_violations(json, test::read_schema("lib/tool/schemas/facts.schema.json")) == std::vector<std::string>{});
    CHECK(json.find("facts")->find("lights")->number == 1);
    CHECK(json.find("facts")->find("point_lights")->number == 0);
    const auto missing = place.run({"facts", "none.scene.json"});
    CHECK(missing.code == 1);
    CHECK_THAT(missing.err, Contains("error[file_missing]"));
}

TEST_CASE("prove holds for an honest prefilter, dark, bright, and with one bright pixel", "[tool][prove]")
{
    const Workplace place;
    place.write("own_bright.glsl", prefilter("image(uv).g < 0.4"));
    place.write("g.graph.json", bloom_graph("own_bright"));
    Picture one = test::flat({32, 18}, {0.1f, 0.1f, 0.1f});
    place.write_picture("dark.pfm", one);
    one.at(20, 10, 1) = 3.0f;
    place.write_picture("one.pfm", one);
    for (const char* picture : {"dark", "one"}) {
        const auto outcome =
            place.run({"prove", "g.graph.json", "--passes", ".", "--in", std::string("image=") + picture + ".pfm", "--json"});
        CHECK(outcome.err == "");
        CHECK(outcome.code == 0);
        const Json json = test::json_of(outcome.out);
        CHECK(test::find_schema_violations(json, test::read_schema("lib/tool/schemas/prove.schema.json")) == std::vector<std::string>{});
        CHECK(json.find("holds")->boolean);
        CHECK((json.find("left_out_by_the_device")->number > 0) == (std::string(picture) == "dark"));
    }
}

TEST_CASE("prove names the first pixel that a false promise changed, and exits with 1", "[tool][prove]")
{
    const Workplace place;
    place.write("g.graph.json", bloom_graph("own_bright"));
    place.write_picture("a.pfm", test::flat({16, 16}, {0.1f, 0.5f, 0.1f}));
    for (const std::string& lie : {prefilter("image(uv).g < 0.8"),                                        // the threshold is another
                                   prefilter("false", R"(, "bound": "image < 0.8 ? 0 : image")"),         // no such bound
                                   prefilter("false", R"(, "ignores": { "image": "image < 0.8" })"),      // it is read
                                   prefilter("false", R"(, "identity": { "when": "image > 0", "is": "image" })"), // what is dark is not
                                   prefilter("false", R"(, "needs": "lights")")}) {                       // it needs none
        INFO(lie);
        place.write("own_bright.glsl", lie);
        // Half of the picture is below what the pass keeps, half above.
        Picture photo = test::flat({16, 16}, {0.1f, 0.3f, 0.1f});
        for (int y = 0; y < 8; ++y)
            for (int x = 0; x < 16; ++x)
                photo.at(x, y, 1) = 0.6f;
        place.write_picture("a.pfm", photo);
        place.write("s.scene.json", R"({ "passgraph_scene": 1, "elements": [] })");
        const auto outcome = place.run({"prove", "g.graph.json", "--passes", ".", "--in", "image=a.pfm", "--scene", "s.scene.json"});
        const bool is_possible = lie.find("bound") == std::string::npos && lie.find("ignores") == std::string::npos;
        if (!is_possible)
            continue; // a host's picture may be as bright as its signal: nothing is concluded
        CHECK(outcome.code == 1);
        CHECK_THAT(outcome.out, Contains("BROKEN"));
        CHECK_THAT(outcome.out, Contains("first color at ("));
        CHECK_THAT(outcome.err, Contains("error[promise_broken]"));
    }
}
