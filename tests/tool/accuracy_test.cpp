// `accuracy`: the program end to end, on few and small ladders.
#include <cstdlib>

#include "program.hpp"
#include "schema.hpp"
#include "support/catch.hpp"

using namespace passgraph;
using test::Workplace;
using Catch::Contains;

TEST_CASE("accuracy leaves a report of the ladders asked for", "[tool][accuracy]")
{
    const Workplace place;
    const test::Outcome outcome = place.run({"accuracy", "fresnel_power", "ggx_form", "--quick", "--size", "64x36", "--out", "report"});
    CHECK_THAT(outcome.err, Contains("left"));
    REQUIRE(outcome.code == 0);
    CHECK(outcome.out == "report/index.html\n");
    const Json json = test::json_of(place.read("report/accuracy.json"));
    CHECK(test::find_schema_violations(json, test::read_schema("lib/tool/schemas/accuracy.schema.json")) == std::vector<std::string>{});
    CHECK(json.find("ladders")->array.size() == 2);
    CHECK(json.find("rungs")->array.size() == 5);
    for (const Json& rung : json.find("rungs")->array)
        CHECK(rung.find("ms")->number > 0.0);
    CHECK(json.find("conditions")->find("quick")->boolean);
    CHECK_THAT(place.read("report/index.html"), Contains("The Fresnel edge"));
    CHECK(place.has("report/charts/ggx_form.png"));
}

TEST_CASE("accuracy refuses a pass's ladder that has no reference, with file and line", "[tool][accuracy]")
{
    const Workplace place;
    place.write("own.glsl", R"(/*{ "pass": "own", "inputs": { "image": "radiance" }, "outputs": { "color": "radiance" },
  "ladders": { "taps": ["1", "2"] } }*/
vec3 own(vec2 uv) { return image(uv) * float(taps + 1); }
)");
    const test::Outcome outcome = place.run({"accuracy", "own.glsl", "--out", "report"});
    CHECK(outcome.code == 1);
    CHECK_THAT(outcome.err, Contains("own.glsl:2:16: error[ladder_without_reference]") && Contains("hint:"));
    CHECK_FALSE(place.has("report"));
    CHECK(place.run({"accuracy", "nothing", "--out", "report"}).code == 1);
    CHECK(place.run({"accuracy", "blur"}).code == 2); // --out is missing
}

TEST_CASE("Ctrl-C keeps what was measured", "[tool][accuracy]")
{
    const Workplace place;
    // A full run takes longer than this on any machine that renders in software; 4 s are enough to have begun. `timeout` signals twice, and
    // so does this: one Ctrl-C often arrives as two.
    const std::string command = std::string(PASSGRAPH_PROGRAM) + " accuracy --out " + place.path("report") + " >/dev/null 2>" + place.path("err") +
                                " & sleep 4; kill -INT $!; sleep 0.05; kill -INT $!; wait $!";
    std::system(command.c_str());
    CHECK_THAT(place.read("err"), Contains("interrupted: "));
    const Json json = test::json_of(place.read("report/accuracy.json"));
    CHECK(test::find_schema_violations(json, test::read_schema("lib/tool/schemas/accuracy.schema.json")) == std::vector<std::string>{});
    CHECK(json.find("conditions")->find("interrupted")->boolean);
    CHECK_THAT(place.read("report/index.html"), Contains("Interrupted"));
}
