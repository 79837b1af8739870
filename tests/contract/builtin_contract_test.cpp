// The contract suite over the built-in passes and a user's, and what the program says of it.
#include <set>

#include <passgraph/core/graph.hpp>

#include "support/catch.hpp"
#include "tool/program.hpp"
#include "tool/schema.hpp"

using namespace passgraph;
using namespace passgraph::test;
using Catch::Contains;

namespace {

/// The names of the checks of a pass that had runs.
std::set<std::string> checks_of(const Json& report)
{
    std::set<std::string> names;
    for (const Json& check : report.find("checks")->array)
        if (check.find("runs")->number > 0.0)
            names.insert(check.find("check")->string);
    return names;
}

const char* const kUserPass = R"(/*{
  "pass": "warmth", "summary": "Warms a picture.", "source": "own",
  "inputs": { "image": "display" }, "outputs": { "color": "display" },
  "params": { "amount": { "type": "float", "default": 0.5, "range": [0, 1] } },
  "identity": { "when": "amount == 0", "is": "image" },
  "contract": { "non_finite": "replaced", "laws": ["black", "monotone"] }
}*/
float kept(float x) { return x > 0.0 ? min(x, 1.0) : 0.0; }
vec3 warmth(vec2 uv)
{
    vec3 seen = image(uv);
    return vec3(kept(seen.x), kept(seen.y), kept(seen.z) * (1.0 - 0.5 * amount));
}
)";

} // namespace

TEST_CASE("every built-in pass keeps its contract, before any guard and with hostile builtins", "[contract][builtin]")
{
    const Workplace place;
    const Outcome outcome = place.run({"test", "--json"});
    CHECK(outcome.code == 0);
    CHECK(outcome.err == "");
    const Json json = json_of(outcome.out);
    CHECK(find_schema_violations(json, read_schema("lib/tool/schemas/test.schema.json")) == std::vector<std::string>{});
    std::set<std::string> tested;
    for (const Json& report : json.find("passes")->array) {
        const std::string name = report.find("pass")->string;
        INFO(name);
        tested.insert(name);
        const PassPtr pass = builtin_passes().find(name);
        REQUIRE(pass);
        const std::set<std::string> checks = checks_of(report);
        CHECK(checks.count("finite") == 1);
        CHECK(checks.count("range") == 1);
        CHECK(checks.count("identity") == (pass->identities.empty() ? 0 : 1));
        CHECK(checks.count("param_range") == (pass->params.empty() ? 0 : 1));
        CHECK(checks.count("replaced") == (pass->contract.non_finite == Contract::NonFinite::replaced ? 1 : 0));
        CHECK(checks.count("layouts") == (pass->layouts.empty() ? 0 : 1));
        for (const Law law : pass->contract.laws)
            CHECK(checks.count("law_" + std::string(passgraph::name(law))) == 1);
        for (const Json& check : report.find("checks")->array)
            for (const Json& finding : check.find("findings")->array)
                FAIL_CHECK(check.find("check")->string << ": " << finding.find("place")->string << ": " << finding.find("got")->string);
    }
    const auto names = builtin_passes().names();
    CHECK(tested == std::set<std::string>(names.begin(), names.end()));
}

TEST_CASE("every built-in pass states a contract", "[contract][builtin]")
{
    for (const auto& [name, pass] : builtin_passes().passes()) {
        INFO(name);
        CHECK(pass->contract.is_stated);
    }
}

TEST_CASE("a user's pass is held to its contract too, by its file or with its folder", "[contract][user]")
{
    const Workplace place;
    place.write("own/warmth.glsl", kUserPass);
    for (const auto& words : {std::vector<std::string>{"test", "own/warmth.glsl"}, {"test", "--passes", "own"}}) {
        const Outcome outcome = place.run(words);
        INFO(outcome.err);
        CHECK(outcome.code == 0);
        CHECK_THAT(outcome.out, Contains("ok    warmth                 replaced"));
        CHECK_THAT(outcome.out, Contains("ok    warmth                 law_monotone"));
        CHECK_THAT(outcome.out, !Contains("vignette"));
    }
}

TEST_CASE("a pass that does not exist or does not load is told, words that are none are refused", "[contract][user]")
{
    const Workplace place;
    place.write("own/warmth.glsl", std::string(kUserPass).replace(std::string(kUserPass).find("seen.x"), 6, "senn.x"));
    CHECK(place.run({"test", "vingette"}).code == 1);
    CHECK_THAT(place.run({"test", "vingette"}).err, Contains("did you mean `vignette`?"));
    const Outcome outcome = place.run({"test", "--passes", "own"});
    CHECK(outcome.code == 1);
    CHECK_THAT(outcome.err, Contains("own/warmth.glsl:12: error[glsl_error]"));
    CHECK(place.run({"test", "--josn"}).code == 2);
}

TEST_CASE("describe tells the contract", "[contract][describe]")
{
    const Workplace place;
    const std::string text = place.run({"describe", "bloom_combine"}).out;
    CHECK_THAT(text, Contains("contract non-finite values reach no further than the pass reads"));
    CHECK_THAT(text, Contains("color  from 0 to 65504, cut off there"));
    CHECK_THAT(text, Contains("scale: twice the light in, exactly twice out"));
    const Json json = json_of(place.run({"describe", "tone_map", "--json"}).out);
    CHECK(json.find("contract")->find("non_finite")->string == "replaced");
}
