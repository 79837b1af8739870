// The typed C++ interface: wrong wires do not compile, and right ones give the plan that a file gives.
#include <type_traits>

#include <passgraph/core/graph_file.hpp>
#include <passgraph/passes.hpp>

#include "core_support.hpp"
#include "support/catch.hpp"

using namespace passgraph;
using namespace passgraph::test;

static_assert(!std::is_convertible_v<Image<Radiance>, Image<Display>>);
static_assert(!std::is_constructible_v<Image<Display>, Image<Radiance>>);
static_assert(!std::is_convertible_v<AnyImage, Image<Radiance>>);
static_assert(!std::is_default_constructible_v<Image<Radiance>>);
static_assert(!std::is_default_constructible_v<AnyImage>);
static_assert(!std::is_convertible_v<Cube<Radiance>, Image<Radiance>>);
static_assert(std::is_convertible_v<Image<Radiance>, AnyImage>);

namespace {

template <class Inputs, class... Wires>
constexpr bool takes = requires(Wires... wires) { Inputs{wires...}; };

using Tone = passes::ToneMap::Inputs;
static_assert(takes<Tone, Image<Radiance>>);
static_assert(!takes<Tone, Image<Display>>);
static_assert(!takes<Tone>); // a forgotten wire
using Film = passes::BloomCombine::Inputs;
static_assert(takes<Film, Image<Radiance>, Image<Radiance>>);
static_assert(!takes<Film, Image<Radiance>>);
static_assert(!takes<Film, Image<Radiance>, Image<Display>>);
using SeenBlur = passes::GaussianBlur<Display>::Inputs;
static_assert(takes<SeenBlur, Image<Display>>);
static_assert(!takes<SeenBlur, Image<Radiance>>);
static_assert(std::is_same_v<decltype(passes::GaussianBlur<Display>::Outputs::blurred), Image<Display>>);

constexpr const char* kFile = R"({
  "passgraph": 1,
  "inputs": { "scene": { "kind": "scene" } },
  "passes": {
    "surface": { "pass": "gbuffer", "inputs": { "scene": "scene" }, "codecs": { "normal": "rgba16f" } },
    "lit":     { "pass": "pbr", "inputs": { "albedo": "surface.albedo", "material": "surface.material", "normal": "surface.normal",
                 "position": "surface.position", "emissive": "surface.emissive", "sky": "scene.sky" } },
    "bright":  { "pass": "bright", "inputs": { "image": "lit" }, "params": { "threshold": 0.9 }, "static": ["knee"] },
    "half":    { "pass": "downsample", "inputs": { "image": "bright" }, "scale": [1, 4] },
    "glow":    { "pass": "gaussian_blur", "inputs": { "image": "half" }, "params": { "sigma": 3.3 }, "rungs": { "taps": "25" } },
    "film":    { "pass": "bloom_combine", "inputs": { "scene": "lit", "bloom": "glow" } },
    "shown":   { "pass": "tone_map", "inputs": { "image": "film" }, "params": { "exposure": 0.01 } },
    "green":   { "pass": "night_vision", "inputs": { "image": "shown" }, "params": { "tint": [0.4, 0.79, 0.11] } }
  },
  "outputs": { "color": "green" }
})";

Graph typed_graph()
{
    Graph graph;
    const auto scene = graph.scene();
    const auto surface = graph.add(passes::Gbuffer<>{}, {.scene = scene}, {.name = "surface", .codecs = {{"normal", "rgba16f"}}});
    const auto lit = graph.add(passes::Pbr{}, {.albedo = surface.albedo, .material = surface.material, .normal = surface.normal, .position = surface.position,
                                               .emissive = surface.emissive, .sky = scene.sky}, {.name = "lit"});
    const auto bright = graph.add(passes::Bright{.threshold = 0.9f}, {.image = lit.radiance}, {.statics = {"knee"}});
    const auto half = graph.add(passes::Downsample<>{}, {.image = bright.color}, {.name = "half", .scale = Ratio{1, 4}});
    const auto glow = graph.add(passes::GaussianBlur<>{.sigma = 3.3f, .taps = passes::GaussianBlur<>::Taps::taps_25}, {.image = half.color}, {.name = "glow"});
    const auto film = graph.add(passes::BloomCombine{}, {.scene = lit.radiance, .bloom = glow.blurred}, {.name = "film"});
    const auto shown = graph.add(passes::ToneMap{.exposure = 0.01f}, {.image = film.color}, {.name = "shown"});
    const auto green = graph.add(passes::NightVision{.tint = {0.4f, 0.79f, 0.11f}}, {.image = shown.color}, {.name = "green"});
    graph.output("color", green.color);
    return graph;
}

} // namespace

TEST_CASE("the same graph in C++ and as a file gives the same plan, byte for byte", "[core][graph]")
{
    const auto description = read_graph_description(kFile, "g.json");
    REQUIRE(description);
    const Plan from_file = planned(build_graph(*description, builtin_passes()), {.extent = {321, 123}});
    const Plan from_code = planned(typed_graph(), {.extent = {321, 123}});
    CHECK(to_json(from_code, true) == to_json(from_file, true));
    CHECK(to_text(from_code) == to_text(from_file));
    CHECK(to_dot(from_code) == to_dot(from_file));
}

TEST_CASE("a value at the end of its range is inside, though binary32 rounds it outwards", "[core][graph]")
{
    Graph graph;
    const auto photo = graph.picture<Radiance>("photo");
    graph.output("color", graph.add(passes::ToneMap{.exposure = 0.01f}, {.image = photo}).color); // 0.01f < 0.01
    CHECK(planned(graph).steps.front().uniforms.front().value == Value(0.01));
    Graph wrong;
    const auto picture = wrong.picture<Radiance>("photo");
    wrong.output("color", wrong.add(passes::ToneMap{.exposure = 0.0099f}, {.image = picture}).color);
    CHECK(codes_of(compile(wrong)) == "param_out_of_range 0:0\n");
}

TEST_CASE("a composite may be used twice without a name", "[core][graph]")
{
    Graph graph;
    const auto photo = graph.picture<Radiance>("photo");
    const auto once = graph.add(passes::GaussianBlur<>{.sigma = 1.0f}, {.image = photo});
    const auto twice = graph.add(passes::GaussianBlur<>{.sigma = 2.0f}, {.image = once.blurred});
    graph.output("color", twice.blurred);
    CHECK(graph.find_node("gaussian_blur.horizontal") >= 0);
    CHECK(graph.find_node("gaussian_blur_2.horizontal") >= 0);
    REQUIRE(graph.set("gaussian_blur_2.sigma", {"", {5.0}, "", {}}));
    CHECK(graph.nodes()[static_cast<size_t>(graph.find_node("gaussian_blur_2.vertical"))].params[0] == Value(5.0));
    CHECK(graph.nodes()[static_cast<size_t>(graph.find_node("gaussian_blur.vertical"))].params[0] == Value(1.0));
    Graph named;
    const auto picture = named.picture<Radiance>("photo");
    named.output("a", named.add(passes::GaussianBlur<>{}, {.image = picture}, {.name = "glow"}).blurred);
    named.output("b", named.add(passes::GaussianBlur<>{}, {.image = picture}, {.name = "glow"}).blurred);
    CHECK(codes_of(compile(named)) == "duplicate_name 0:0\n");
}
