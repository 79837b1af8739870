// Alpha: a generic pass written for three channels carries the fourth.
#include "graphs/graph_runner.hpp"
#include "support/catch.hpp"
#include "support/pass_runner.hpp"

using namespace passgraph;
using namespace passgraph::test;

TEST_CASE("generic passes carry alpha, fused or not", "[graphs][alpha]")
{
    const Graph graph = graph_of(R"({
      "passgraph": 1,
      "inputs": { "picture": "display_alpha" },
      "passes": {
        "first":  { "pass": "vignette", "inputs": { "image": "picture" }, "codecs": { "color": "rgba32f" } },
        "second": { "pass": "vignette", "inputs": { "image": "first" }, "codecs": { "color": "rgba32f" } }
      },
      "outputs": { "color": "second" }
    })");
    GraphRun run;
    run.options.extent = {9, 5};
    run.pictures = {{"picture", noise({9, 5}, 4, 0.0f, 1.0f, 3)}};
    for (const bool is_fused : {true, false}) {
        run.options.fuse = is_fused;
        const Picture result = run_graph(graph, run).at("color");
        REQUIRE(result.channels == 4);
        for (int y = 0; y < 5; ++y)
            for (int x = 0; x < 9; ++x)
                CHECK(result.at(x, y, 3) == run.pictures.at("picture").at(x, y, 3));
    }
}
