// What a scene's facts and the parameters' values make superfluous.
#include <algorithm>

#include <passgraph/core/facts.hpp>
#include <passgraph/core/graph_file.hpp>

#include "core_support.hpp"
#include "support/catch.hpp"

using namespace passgraph;
using namespace passgraph::test;
using Catch::Contains;

namespace {

Graph built(const std::string& text)
{
    const auto description = read_graph_description(text, "g.graph.json");
    REQUIRE(description);
    return build_graph(*description, builtin_passes());
}

/// A picture through vignette, a blur of sigma 2 and a grade, some of which may be their input.
std::string chain(const std::string& amount, const std::string& more = "")
{
    return R"({ "passgraph": 1, "inputs": { "photo": "display" }, "passes": {
      "first": { "pass": "night_vision", "inputs": { "image": "photo" } },
      "edge":  { "pass": "vignette", "inputs": { "image": "first" }, "params": { "amount": )" + amount + " }" + more + R"( },
      "soft":  { "pass": "gaussian_blur", "inputs": { "image": "edge" }, "params": { "sigma": 2 } } },
      "outputs": { "color": "soft" } })";
}

const std::string kLit = R"({ "passgraph": 1, "inputs": { "scene": { "kind": "scene" } }, "passes": {
  "surface": { "pass": "gbuffer", "inputs": { "scene": "scene" } },
  "lit": { "pass": "pbr", "inputs": { "albedo": "surface.albedo", "material": "surface.material", "normal": "surface.normal",
           "position": "surface.position", "emissive": "surface.emissive", "sky": "scene.sky" } },
  "view": { "pass": "sky", "inputs": { "image": "lit", "depth": "surface.depth", "sky": "scene.sky" } },
  "bright": { "pass": "bright", "inputs": { "image": "view" }, "params": { "threshold": 0.8, "knee": 0.5 } },
  "half": { "pass": "downsample", "inputs": { "image": "bright" } },
  "film": { "pass": "bloom_combine", "inputs": { "scene": "view", "bloom": "half" } },
  "shown": { "pass": "tone_map", "inputs": { "image": "film" } } },
  "outputs": { "color": "shown" } })";

/// A scene in which there is nothing.
Facts nothing()
{
    Facts facts;
    for (const FactRow& row : all_facts())
        if (row.set != nullptr)
            row.set(facts, 0.0);
    return facts;
}

std::string reason_of(const Plan& plan, const std::string& pass)
{
    for (const Plan::Culled& culled : plan.culled)
        if (culled.pass == pass)
            return culled.reason;
    return "it runs";
}

std::string fragment_with(const Plan& plan, const std::string& pass)
{
    for (const Plan::Step& step : plan.steps)
        if (std::find(step.passes.begin(), step.passes.end(), pass) != step.passes.end())
            return step.fragment;
    return "";
}

bool has_live(const Plan& plan, const std::string& place)
{
    return std::any_of(plan.steps.begin(), plan.steps.end(), [&](const Plan::Step& step) {
        return std::any_of(step.uniforms.begin(), step.uniforms.end(), [&](const auto& uniform) { return uniform.place == place; });
    });
}

} // namespace

TEST_CASE("a pass that is its input is left out, and its readers read that", "[core][specialise]")
{
    CHECK(reason_of(planned(built(chain("0.5"))), "edge") == "it runs");
    const Plan plan = planned(built(chain("0")));
    CHECK_THAT(reason_of(plan, "edge"), Contains("it is its `image`: amount == 0"));
    CHECK(std::any_of(plan.steps.begin(), plan.steps.end(), [](const Plan::Step& step) {
        return std::any_of(step.reads.begin(), step.reads.end(), [](const Plan::Read& read) { return read.image == "first"; });
    }));
}

TEST_CASE("a pass with a codec of its own rounds, and stays", "[core][specialise]")
{
    CHECK(reason_of(planned(built(chain("0", R"(, "codecs": { "color": "rgb10_a2" })"))), "edge") == "it runs");
}

TEST_CASE("a graph's output keeps its image where only the host's picture could stand for it", "[core][specialise]")
{
    const Plan plan = planned(built(R"({ "passgraph": 1, "inputs": { "photo": "display" }, "passes": {
      "edge": { "pass": "vignette", "inputs": { "image": "photo" }, "params": { "amount": 0 } } }, "outputs": { "color": "edge" } })"));
    CHECK(plan.steps.size() == 1);
    CHECK(plan.outputs.front().image == "edge");
}

TEST_CASE("where nothing can be bright enough bloom is gone, and its readers read the picture", "[core][specialise]")
{
    Facts dark = nothing();
    dark.emission = 0.39; // below 0.8 - 0.8 * 0.5
    CompileOptions options;
    options.facts = dark;
    const Plan plan = planned(built(kLit), options);
    for (const char* pass : {"bright", "half"})
        CHECK(reason_of(plan, pass) == "black");
    CHECK_THAT(reason_of(plan, "film"), Contains("it is its `scene`"));
    CHECK_THAT(reason_of(plan, "view"), Contains("it is its `image`")); // there is no sky
    CHECK_THAT(reason_of(plan, "lit.share"), Contains("nothing needs it here"));
    options.facts.emission = 0.41;
    CHECK(reason_of(planned(built(kLit), options), "half") == "it runs");
    options.facts = dark;
    options.facts.sky = 0.2; // 0.39 + 2.5 * 0.2
    CHECK(reason_of(planned(built(kLit), options), "half") == "it runs");
    options.facts = dark;
    options.facts.point_lights = 1.0;
    options.facts.irradiance = 1.0;
    options.facts.highlight = 0.5;
    CHECK(reason_of(planned(built(kLit), options), "half") == "it runs");
}

TEST_CASE("an unknown scene leaves everything in, and so do switches", "[core][specialise]")
{
    CompileOptions options;
    const Plan general = planned(built(kLit), options);
    CHECK(general.decisions.empty());
    CHECK(general.facts == Facts{});
    options.facts = nothing();
    CHECK(planned(built(kLit), options).facts == nothing());
    for (const bool guards : {true, false}) {
        options.guards = guards;
        options.specialise = !guards;
        const Plan whole = planned(built(kLit), options);
        CHECK(whole.decisions.empty());
        CHECK(reason_of(whole, "half") == "it runs");
    }
}

TEST_CASE("an input that makes no difference is not read, and its parameter is live no more", "[core][specialise]")
{
    Graph graph = built(kLit);
    CHECK(has_live(planned(graph), "lit.environment"));
    REQUIRE(graph.set("lit.environment", {"", {0.0}, "", {}}));
    const Plan plan = planned(graph);
    CHECK_FALSE(has_live(plan, "lit.environment"));
    CHECK(reason_of(plan, "lit.share") == "nothing needs it here");
    CHECK_THAT(to_text(plan), Contains("lit.surface.sky: not read: environment == 0"));
}

TEST_CASE("few lamps are uniforms, many a buffer, and absent kinds fold away", "[core][specialise]")
{
    CompileOptions options;
    options.facts = nothing();
    options.facts.irradiance = options.facts.highlight = 1.0; // else all were black
    for (int count = 0; count <= 5; ++count) {
        options.facts.directional_lights = count;
        const std::string text = fragment_with(planned(built(kLit), options), "lit.surface");
        CAPTURE(count);
        CHECK((text.find("passgraph_light_rows[" + std::to_string(3 * count) + "]") != std::string::npos) == (count >= 1 && count <= 4));
        CHECK((text.find("samplerBuffer") != std::string::npos) == (count == 5));
        CHECK_THAT(text, Contains("bool lights_have_cones() { return false; }"));
        CHECK_THAT(text, Contains("bool lights_have_ends() { return false; }"));
        CHECK_THAT(text, Contains("bool materials_have_metal() { return false; }"));
    }
    const std::string general = fragment_with(planned(built(kLit)), "lit.surface");
    CHECK_THAT(general, Contains("bool lights_have_cones() { return true; }"));
    CHECK_THAT(general, Contains("bool materials_have_metal() { return true; }"));
}

TEST_CASE("a pass whose need is not met is its input, or black", "[core][specialise]")
{
    PassLibrary library;
    for (const char* text : {R"(/*{ "pass": "glare", "inputs": { "image": "radiance" }, "outputs": { "color": "radiance" }, "needs": "lights",
                                "params": { "amount": 1 }, "identity": { "when": "amount == 0", "is": "image" } }*/
vec3 glare(vec2 uv) { return image(uv) * (1.0 + amount); }
)",
                             R"(/*{ "pass": "beam", "inputs": { "image": "radiance" }, "outputs": { "color": "radiance" }, "needs": ["sky", "lights"] }*/
vec3 beam(vec2 uv) { return image(uv); }
)",
                             R"(/*{ "pass": "sum", "inputs": { "left": "radiance", "right": "radiance" }, "outputs": { "color": "radiance" } }*/
vec3 sum(vec2 uv) { return left(uv) + right(uv); }
)"})
        library.add(std::make_shared<const PassDeclaration>(read_pass(text)));
    const auto description = read_graph_description(R"({ "passgraph": 1, "inputs": { "photo": "radiance" }, "passes": {
      "g": { "pass": "glare", "inputs": { "image": "photo" } }, "b": { "pass": "beam", "inputs": { "image": "photo" } },
      "s": { "pass": "sum", "inputs": { "left": "g", "right": "b" } } }, "outputs": { "color": "s" } })",
                                                    "g.graph.json");
    REQUIRE(description);
    const Graph graph = build_graph(*description, library);
    CompileOptions options;
    CHECK(planned(graph, options).decisions.empty());
    options.facts.directional_lights = options.facts.point_lights = options.facts.spot_lights = 0.0;
    const Plan plan = planned(graph, options);
    CHECK_THAT(reason_of(plan, "g"), Contains("it is its `image`: the scene has no lights"));
    CHECK_THAT(reason_of(plan, "b"), Contains("the scene has no lights: black"));
    options.facts.spot_lights = 1.0;
    CHECK(planned(graph, options).decisions.empty());
}

TEST_CASE("facts of two scenes together hold for either, and broken ones are named", "[core][facts]")
{
    Facts a = nothing();
    a.spot_lights = 2.0;
    Facts b = nothing();
    b.sky = 3.0;
    const Facts both = either(a, b);
    CHECK(both.spot_lights == 2.0);
    CHECK(both.sky == 3.0);
    CHECK(broken_promises(both, a).empty());
    CHECK(broken_promises(both, b).empty());
    REQUIRE(broken_promises(a, b).size() == 1);
    CHECK_THAT(broken_promises(a, b).front(), Contains("`sky`") && Contains("the scene has 3"));
    CHECK(broken_promises(Facts{}, both).empty());
    CHECK(find_fact("lights")->get(a) == 2.0);
    CHECK(find_fact("nonsense") == nullptr);
}
