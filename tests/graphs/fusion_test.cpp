// Fusion: one draw gives the picture that four give, within what the removed stores rounded.
#include "graphs/graph_runner.hpp"
#include "support/catch.hpp"
#include "support/pass_runner.hpp"

using namespace passgraph;
using namespace passgraph::test;

namespace {

const char* const kChain = R"({
  "passgraph": 1,
  "inputs": { "scene": "radiance", "bloom": "radiance" },
  "passes": {
    "film":  { "pass": "bloom_combine", "inputs": { "scene": "scene", "bloom": "bloom" } },
    "shown": { "pass": "tone_map", "inputs": { "image": "film" } },
    "green": { "pass": "night_vision", "inputs": { "image": "shown" }, "params": { "amount": 0.7 } },
    "rim":   { "pass": "vignette", "inputs": { "image": "green" }, "codecs": { "color": "rgba32f" } }
  },
  "outputs": { "color": "rim" }
})";

GraphRun chain_run(Extent extent, bool is_fused)
{
    GraphRun run;
    run.options.extent = extent;
    run.options.fuse = is_fused;
    run.pictures = {{"scene", noise(extent, 3, 0.0f, 4.0f, 1)}, {"bloom", noise(extent, 3, 0.0f, 0.5f, 2)}};
    return run;
}

} // namespace

TEST_CASE("a fused chain differs from the unfused by no more than the removed stores rounded", "[graphs][fusion]")
{
    const Graph graph = graph_of(kChain);
    for (const Extent extent : {Extent{1, 1}, Extent{1, 9}, Extent{17, 13}, Extent{64, 48}}) {
        const Picture fused = run_graph(graph, chain_run(extent, true)).at("color");
        const Picture apart = run_graph(graph, chain_run(extent, false)).at("color");
        // Removed stores: film in rgba16f, relative 2^-10 when truncated; shown and green in rgba8, half a code (rounded)
        // or a whole one (truncated), 1/255 each. film's error passes the film curve and its encoding: d(display)/d(ln x)
        // = x f'(x) is at most 0.22 for Hable's curve after sRGB encoding (its steepest is near x = 0.5), so it adds
        // 0.22 * 2^-10. green and rim scale by at most 1. Arithmetic in binary32 stays below 1e-5.
        const float bound = 2.0f / 255.0f + 0.22f / 1024.0f + 1e-5f;
        const float difference = largest_difference(fused, apart);
        CHECK(difference <= bound);
    }
}

TEST_CASE("with stores that round nothing, fusion changes nothing that can be seen", "[graphs][fusion]")
{
    Graph graph = graph_of(kChain);
    for (const char* image : {"film", "shown", "green"})
        REQUIRE(graph.set_codec(image, "rgba32f"));
    const Extent extent{33, 17};
    const Picture fused = run_graph(graph, chain_run(extent, true)).at("color");
    const Picture apart = run_graph(graph, chain_run(extent, false)).at("color");
    // The same operations in the same order; a compiler may contract a multiply and an add across the removed border,
    // once per pass: four roundings of values up to 1 (the film curve's slope is below 1.5 after encoding).
    CHECK(largest_difference(fused, apart) <= 4.0f * 1.5f * 1.2e-7f);
}

TEST_CASE("fusion makes one step of the chain, and --off fuse four", "[graphs][fusion]")
{
    const Graph graph = graph_of(kChain);
    CHECK(compile(graph, chain_run({16, 16}, true).options)->steps.size() == 1);
    CHECK(compile(graph, chain_run({16, 16}, false).options)->steps.size() == 4);
}

TEST_CASE("a non-finite texel of an import reaches no output, fused or not", "[graphs][fusion]")
{
    const Graph graph = graph_of(kChain);
    for (const bool is_fused : {true, false}) {
        GraphRun run = chain_run({8, 8}, is_fused);
        run.pictures["scene"].at(3, 3, 0) = std::nanf("");
        run.pictures["scene"].at(4, 4, 1) = INFINITY;
        run.pictures["scene"].at(5, 5, 2) = -INFINITY;
        const Picture picture = run_graph(graph, run).at("color");
        for (const float value : picture.texels) {
            CHECK(value >= 0.0f);
            CHECK(value <= 1.0f);
        }
    }
}

TEST_CASE("sharing memory changes no texel", "[graphs][fusion]")
{
    GraphRun run = chain_run({40, 30}, false);
    const Graph graph = graph_of(kChain);
    const Picture shared = run_graph(graph, run).at("color");
    run.options.alias = false;
    CHECK(largest_difference(shared, run_graph(graph, run).at("color")) == 0.0f);
}
