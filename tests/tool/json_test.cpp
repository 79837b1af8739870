// `passes` and `describe`: complete, and as their schemas say; the schemas of what is read.
#include <algorithm>
#include <filesystem>
#include <set>

#include "program.hpp"
#include "schema.hpp"
#include "support/catch.hpp"

using namespace passgraph;
using test::Workplace;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

using Violations = std::vector<std::string>;

/// The files of the built-in passes with this ending, as names of passes.
std::set<std::string> pass_files(const std::string& ending)
{
    std::set<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(PASSGRAPH_SOURCE_DIR) / "passes")) {
        const std::string name = entry.path().filename().string();
        if (name.ends_with(ending) && entry.path().parent_path().filename() != "common")
            names.insert(name.substr(0, name.size() - ending.size()));
    }
    return names;
}

} // namespace

TEST_CASE("passes lists every pass, and its JSON keeps its schema", "[tool][passes]")
{
    const Workplace place;
    const test::Outcome outcome = place.run({"passes", "--json"});
    REQUIRE(outcome.code == 0);
    const Json json = test::json_of(outcome.out);
    CHECK(test::find_schema_violations(json, test::read_schema("lib/tool/schemas/passes.schema.json")) == Violations{});
    std::set<std::string> listed;
    for (const Json& pass : json.find("passes")->array)
        listed.insert(pass.find("name")->string);
    std::set<std::string> expected = pass_files(".glsl");
    expected.merge(pass_files(".graph.json"));
    CHECK(listed == expected);
    const std::string text = place.run({"passes"}).out;
    for (const std::string& name : expected)
        CHECK_THAT(text, Contains(name));
}

TEST_CASE("describe tells ports, parameters, choices, ladders and layouts", "[tool][describe]")
{
    const Workplace place;
    place.write("own/all.glsl", R"(/*{ "pass": "one_of_each", "summary": "Has one of each.", "source": "none",
  "inputs": { "image": { "signal": "color", "filter": "linear", "wrap": "mirror" },
              "other": { "signal": "mask", "optional": true, "default": 0.5 } },
  "outputs": { "color": { "signal": "color", "size": { "of": "image", "scale": [1, 2] } } },
  "params": { "strength": { "type": "float", "default": 0.5, "range": [0, 1], "unit": "texels", "label": "How much" },
              "kind": { "type": "enum", "items": ["soft", "hard"], "default": "hard" },
              "inverted": false },
  "choices": { "shape": ["round", "square"] }, "ladders": { "taps": ["5", "9"] } }*/
vec3 one_of_each(vec2 uv)
{
    float level = inverted ? 1.0 - other(uv) : other(uv);
#if shape == shape_square && taps == taps_9
    level *= 0.5;
#endif
    return image(uv) * strength * level * (kind == kind_hard ? 1.0 : 0.5);
}
)");
    const test::Outcome outcome = place.run({"describe", "own/all.glsl", "--json"});
    CHECK(outcome.err == "");
    REQUIRE(outcome.code == 0);
    const Json json = test::json_of(outcome.out);
    CHECK(test::find_schema_violations(json, test::read_schema("lib/tool/schemas/describe.schema.json")) == Violations{});
    CHECK(json.find("params")->array[1].find("default")->string == "hard");
    CHECK(json.find("params")->array[2].find("default")->boolean == false);
    CHECK(json.find("inputs")->array[0].find("access")->string == "pointwise");
    CHECK(json.find("ladders")->array[0].find("items")->array[1].string == "9");
    const std::string text = place.run({"describe", "own/all.glsl"}).out;
    CHECK_THAT(text, Contains("Has one of each.") && Contains("linear, mirror") && Contains("read pointwise") && Contains("1/2 of image") &&
                         Contains("strength  float = 0.5  in [0, 1] texels; How much") && Contains("one of soft, hard") &&
                         Contains("shape  choice = round; items: round, square") && Contains("taps  ladder"));
    CHECK_THAT(place.run({"describe", "gbuffer"}).out, Contains("layout four_target") && Contains("octahedral_rg16"));
    const test::Outcome unknown = place.run({"describe", "vignete"});
    CHECK(unknown.code == 1);
    CHECK_THAT(unknown.err, Contains("error[unknown_pass]") && Contains("did you mean `vignette`?"));
}

TEST_CASE("every graph of the repository keeps the schema of graphs and is one that the reader takes", "[tool][schema]")
{
    const Json schema = test::read_schema("lib/core/graph.schema.json");
    const Workplace place;
    int count = 0;
    for (const char* folder : {"passes", "samples"}) {
        for (const auto& entry : fs::recursive_directory_iterator(fs::path(PASSGRAPH_SOURCE_DIR) / folder)) {
            if (!entry.path().string().ends_with(".graph.json"))
                continue;
            INFO(entry.path());
            const auto json = parse_json(read_text_file(entry.path()).value(), entry.path());
            REQUIRE(json);
            CHECK(test::find_schema_violations(*json, schema) == Violations{});
            const fs::path beside = entry.path().parent_path();
            const bool has_passes = std::any_of(fs::directory_iterator(beside), fs::directory_iterator(),
                                                [](const auto& file) { return file.path().extension() == ".glsl"; });
            std::vector<std::string> words = {"check", entry.path()};
            if (has_passes)
                words.insert(words.end(), {"--passes", beside});
            CHECK(place.run(words).err == "");
            ++count;
        }
    }
    CHECK(count >= 1);
}

TEST_CASE("the schema of graphs names exactly the fields that the reader knows", "[tool][schema]")
{
    const Json schema = test::read_schema("lib/core/graph.schema.json");
    const Workplace place;
    const auto properties = [](const Json& object) {
        std::set<std::string> names;
        for (const auto& member : object.find("properties")->members)
            names.insert(member.key);
        return names;
    };
    const auto known = [&](const std::string& text) {
        place.write("g.graph.json", text);
        const std::string err = place.run({"check", "g.graph.json"}).err;
        const std::string start = "fields are: ";
        const size_t at = err.find(start);
        INFO(err);
        REQUIRE(at != std::string::npos);
        std::string rest = err.substr(at + start.size(), err.find('\n', at) - at - start.size()) + ", ";
        std::set<std::string> names;
        for (size_t comma; (comma = rest.find(", ")) != std::string::npos; rest = rest.substr(comma + 2))
            names.insert(rest.substr(0, comma));
        return names;
    };
    const std::string odd = "\"qqqqqqqqqqqqqqqqqqqq\": 0";
    const std::string start = R"({ "passgraph": 1, "outputs": {}, "passes": {)";
    CHECK(properties(schema) == known(start + "}, " + odd + " }"));
    CHECK(properties(*schema.find("$defs")->find("pass")) == known(start + R"( "a": { "pass": "sky", )" + odd + " } } }"));
    CHECK(properties(*schema.find("$defs")->find("input")) ==
          known(R"({ "passgraph": 1, "outputs": {}, "passes": {}, "inputs": { "a": { "signal": "mask", )" + odd + " } } }"));
}
