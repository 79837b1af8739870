// `render`: what comes out, at which size, for which files.
#include <cmath>

#include "program.hpp"
#include "support/catch.hpp"

using namespace passgraph;
using test::Workplace;
using Catch::Contains;

namespace {

/// A pass that returns what it reads times a parameter, with an enum and a choice beside.
constexpr const char* kScaled = R"(/*{ "pass": "scaled", "summary": "Multiplies.",
  "inputs": { "image": "radiance" }, "outputs": { "color": "radiance" },
  "params": { "factor": { "type": "float", "default": 1, "range": [-8, 8] },
              "tint": { "type": "color", "default": [1, 1, 1], "range": [0, 1] },
              "swapped": { "type": "bool", "default": false } },
  "choices": { "offset": ["none", "one"] },
  "ladders": { "steps": ["5", "9"] } }*/
vec3 scaled(vec2 uv)
{
    vec3 seen = image(uv) * factor * tint;
#if offset == offset_one
    seen += 1.0;
#endif
#if steps == steps_9
    seen += 9.0;
#endif
    return swapped ? seen.bgr : seen;
}
)";

constexpr const char* kGraph = R"({ "passgraph": 1, "inputs": { "image": "radiance" },
  "passes": { "first": { "pass": "scaled", "inputs": { "image": "image" } },
              "second": { "pass": "scaled", "inputs": { "image": "first" }, "params": { "factor": 2 } } },
  "params": { "gain": ["first.factor", "second.factor"] },
  "outputs": { "color": "second" } })";

void write_scaled(const Workplace& place)
{
    place.write("own/scaled.glsl", kScaled);
    place.write("g.graph.json", kGraph);
    place.write_picture("a.pfm", test::flat({6, 4}, {0.125f, 0.25f, 0.5f}));
}

/// The first texel of `--out color=` with further words.
std::vector<float> rendered(const Workplace& place, const std::vector<std::string>& more, const std::string& output = "color")
{
    std::vector<std::string> words = {"render", "g.graph.json", "--passes", "own", "--in", "image=a.pfm", "--out", output + "=out.pfm"};
    words.insert(words.end(), more.begin(), more.end());
    const test::Outcome outcome = place.run(words);
    CHECK(outcome.err == "");
    REQUIRE(outcome.code == 0);
    const Picture picture = place.read_picture("out.pfm");
    return {picture.at(0, 0, 0), picture.at(0, 0, 1), picture.at(0, 0, 2)};
}

using Texel = std::vector<float>;

} // namespace

TEST_CASE("a user's pass renders, and settings reach parameters, choices and rungs", "[tool][render]")
{
    const Workplace place;
    write_scaled(place);
    // All values are exact in binary16, which the images are stored in.
    CHECK(rendered(place, {}) == Texel{0.25f, 0.5f, 1.0f});
    CHECK(rendered(place, {"--set", "second.factor=4"}) == Texel{0.5f, 1.0f, 2.0f});
    CHECK(rendered(place, {"--set", "gain=0.5"}) == Texel{0.03125f, 0.0625f, 0.125f});
    CHECK(rendered(place, {"--set", "second.tint=1,0.5,0"}) == Texel{0.25f, 0.25f, 0.0f});
    CHECK(rendered(place, {"--set", "second.swapped=true"}) == Texel{1.0f, 0.5f, 0.25f});
    CHECK(rendered(place, {"--set", "second.offset=one"}) == Texel{1.25f, 1.5f, 2.0f});
    CHECK(rendered(place, {"--set", "second.steps=9"}) == Texel{9.25f, 9.5f, 10.0f});
    CHECK(rendered(place, {"--off", "fuse,cull,alias"}) == Texel{0.25f, 0.5f, 1.0f});
    CHECK(rendered(place, {}, "first") == Texel{0.125f, 0.25f, 0.5f});
    CHECK(rendered(place, {}, "first.color") == Texel{0.125f, 0.25f, 0.5f});
}

TEST_CASE("a preset applies before the settings", "[tool][render]")
{
    const Workplace place;
    write_scaled(place);
    place.write("p.json", R"({ "passgraph_preset": 1, "values": { "second.factor": 4, "second.offset": "one", "second.swapped": true } })");
    CHECK(rendered(place, {"--preset", "p.json"}) == Texel{3.0f, 2.0f, 1.5f});
    CHECK(rendered(place, {"--preset", "p.json", "--set", "second.offset=none"}) == Texel{2.0f, 1.0f, 0.5f});
}

TEST_CASE("a user's pass replaces a built-in one of the same name", "[tool][render]")
{
    const Workplace place;
    place.write("g.graph.json", test::tone_map_graph());
    place.write("own/bright.glsl", R"(/*{ "pass": "bright", "inputs": { "image": "radiance" }, "outputs": { "color": "radiance" },
  "params": { "threshold": 0.0 } }*/
vec3 bright(vec2 uv) { return image(uv) * 0.0 + vec3(0.75 + threshold); }
)");
    place.write_picture("a.pfm", test::flat({2, 2}, {1, 1, 1}));
    const test::Outcome outcome =
        place.run({"render", "g.graph.json", "--passes", "own", "--in", "image=a.pfm", "--out", "bright_part=out.pfm"});
    CHECK(outcome.err == "");
    REQUIRE(outcome.code == 0);
    CHECK(place.read_picture("out.pfm").at(1, 1, 2) == 0.75f);
}

TEST_CASE("the extent is --size, else the first picture's", "[tool][render]")
{
    const Workplace place;
    write_scaled(place);
    rendered(place, {});
    CHECK(place.read_picture("out.pfm").extent == Extent{6, 4});
    CHECK(rendered(place, {"--size", "17x13"}) == Texel{0.25f, 0.5f, 1.0f});
    CHECK(place.read_picture("out.pfm").extent == Extent{17, 13});
    CHECK(rendered(place, {"--size", "1x1"}) == Texel{0.25f, 0.5f, 1.0f});
}

TEST_CASE("an extent of no texels is a mistake, one beyond the device a lack of the machine", "[tool][render]")
{
    const Workplace place;
    write_scaled(place);
    const auto outcome = [&](const std::string& size) {
        return place.run({"render", "g.graph.json", "--passes", "own", "--in", "image=a.pfm", "--out", "color=out.pfm", "--size", size});
    };
    CHECK(outcome("0x4").code == 1);
    CHECK_THAT(outcome("0x4").err, Contains("error[extent_empty]"));
    for (const char* size : {"100000x4", "4x99999999999999999999"}) {
        CHECK(outcome(size).code == 3);
        CHECK_THAT(outcome(size).err, Contains("error[extent_too_large]"));
    }
    CHECK_FALSE(place.has("out.pfm"));
}

TEST_CASE("inputs that are missing, unknown or given twice say what the graph wants", "[tool][render]")
{
    const Workplace place;
    write_scaled(place);
    const auto errors = [&](const std::vector<std::string>& pairs) {
        std::vector<std::string> words = {"render", "g.graph.json", "--passes", "own", "--out", "color=out.pfm"};
        for (const std::string& pair : pairs)
            words.insert(words.end(), {"--in", pair});
        const test::Outcome outcome = place.run(words);
        CHECK(outcome.code == 1);
        return outcome.err;
    };
    CHECK_THAT(errors({}), Contains("error[input_missing]") && Contains("--in image=FILE"));
    CHECK_THAT(errors({"imge=a.pfm"}), Contains("error[unknown_input]") && Contains("`image` (radiance)") && Contains("error[input_missing]"));
    CHECK_THAT(errors({"image=a.pfm", "image=a.pfm"}), Contains("error[duplicate_name]"));
    CHECK_THAT(errors({"first=a.pfm", "image=a.pfm"}), Contains("error[unknown_input]"));
    CHECK_FALSE(place.has("out.pfm"));
}

TEST_CASE("codes of a display become radiance when read, and display when written", "[tool][render]")
{
    const Workplace place;
    write_scaled(place);
    place.write_picture("a.png", test::flat({2, 2}, {0.5f, 0.5f, 0.5f})); // code 128
    const auto outcome = place.run({"render", "g.graph.json", "--passes", "own", "--in", "image=a.png", "--set", "gain=1", "--out", "color=out.pfm"});
    CHECK(outcome.err == "");
    REQUIRE(outcome.code == 0);
    const double linear = std::pow((128.0 / 255.0 + 0.055) / 1.055, 2.4);
    CHECK(place.read_picture("out.pfm").at(0, 0) == Approx(linear).epsilon(0x1p-10)); // two stores in binary16, cut off
}
