// A pass whose one reader looks at each texel about once is computed where that looks, and makes the same picture.
#include <algorithm>

#include "graphs/graph_runner.hpp"
#include "support/catch.hpp"
#include "support/pass_runner.hpp"
#include "support/test_context.hpp"

using namespace passgraph;
using namespace passgraph::test;

namespace {

constexpr double kRounding = 1.0 / 16777216.0;

/// What is bright of a photo, made smaller; `more` are further passes, outputs for the graph's own.
Graph smaller(const std::string& scale, const std::string& more = "", const std::string& outputs = "")
{
    return graph_of(R"({ "passgraph": 1, "inputs": { "photo": "radiance" }, "passes": {
        "bright": { "pass": "bright", "inputs": { "image": "photo" }, "codecs": { "color": "rgba32f" } },
        "small": { "pass": "downsample", "inputs": { "image": "bright" }, "scale": )" + scale + R"(, "codecs": { "color": "rgba32f" } })" + more +
                    R"( }, "outputs": { "color": "small")" + outputs + " } }");
}

std::vector<std::string> names_of(const Graph& graph, CompileOptions options = {})
{
    const auto plan = compile(graph, options);
    REQUIRE(plan);
    std::vector<std::string> names;
    for (const Plan::Step& step : plan->steps)
        names.push_back(step.name);
    return names;
}

} // namespace

TEST_CASE("what is computed where a downsampling looks is what it would read, at even and odd extents", "[graphs][called]")
{
    unsigned seed = 300;
    for (const char* scale : {"[1, 2]", "[1, 4]", "[1, 8]", "[3, 7]", "[1, 1]"})
        for (const Extent extent : {Extent{64, 24}, Extent{17, 13}, Extent{1, 31}, Extent{1, 1}}) {
            CAPTURE(scale, extent.width, extent.height);
            const Graph graph = smaller(scale);
            GraphRun run;
            run.pictures = {{"photo", noise(extent, 3, 0.0f, 4.0f, seed++)}};
            run.options.extent = extent;
            const Picture called = run_graph(graph, run).at("color");
            run.options.fuse = false;
            const Picture stored = run_graph(graph, run).at("color");
            REQUIRE(called.extent == stored.extent);
            // Both find a place by a product and a difference of up to 64 texels, the sampler by two roundings more, times the
            // largest step between neighbours; three interpolations each add 6 roundings of the value, a sum of 16 taps as many.
            const double bound = (2.0 * 4.0 * 64.0 + 2.0 * 6.0 + 2.0 * 16.0) * kRounding * 4.0;
            CHECK(largest_difference(called, stored) <= static_cast<float>(bound));
        }
}

TEST_CASE("a texel that is loaded is the one that a sampler finds, to the last bit", "[graphs][called]")
{
    const int most = query_device(test_context().loader())->max_loaded_images;
    for (const char* codec : {"rgba16f", "rgba32f", "r11f_g11f_b10f"})
        for (const Extent extent : {Extent{64, 24}, Extent{17, 13}, Extent{1, 31}, Extent{1, 1}}) {
            CAPTURE(codec, extent.width, extent.height);
            const Graph graph = graph_of(R"({ "passgraph": 1, "inputs": { "photo": "radiance" }, "passes": {
                "dim": { "pass": "vignette", "inputs": { "image": "photo" }, "codecs": { "color": ")" + std::string(codec) + R"(" } },
                "bright": { "pass": "bright", "inputs": { "image": "dim" } },
                "small": { "pass": "downsample", "inputs": { "image": "bright" }, "codecs": { "color": "rgba32f" } } },
              "outputs": { "color": "small" } })");
            GraphRun run;
            run.pictures = {{"photo", noise(extent, 3, 0.0f, 4.0f, 350)}};
            run.options.extent = extent;
            const Picture sampled = run_graph(graph, run).at("color");
            run.options.device.max_loaded_images = most;
            const auto plan = compile(graph, run.options);
            REQUIRE(plan);
            CHECK(plan->steps.back().reads.front().is_loaded == (most > 0));
            CHECK(run_graph(graph, run).at("color").texels == sampled.texels);
        }
}

TEST_CASE("a pass is computed where its reader looks only if nobody else needs it", "[graphs][called]")
{
    using Names = std::vector<std::string>;
    CHECK(names_of(smaller("[1, 2]")) == Names{"bright + small"});
    CHECK(names_of(smaller("[1, 2]"), {.fuse = false}) == Names{"bright", "small"});
    CompileOptions narrow;
    narrow.device.max_texture_units = 1; // none beside the lights'
    CHECK(names_of(smaller("[1, 2]"), narrow) == Names{"bright", "small"});
    CHECK(names_of(smaller("[1, 2]", "", R"(, "bright": "bright")")) == Names{"bright", "small"});
    CHECK(names_of(smaller("[1, 2]", R"(, "other": { "pass": "vignette", "inputs": { "image": "bright" } })", R"(, "other": "other")")) ==
          Names{"bright + other", "small"});
    // Who looks at neighbours, or is bound to its own pixel, is stored: computing it again and again would cost more.
    CHECK(names_of(graph_of(R"({ "passgraph": 1, "inputs": { "photo": "radiance" }, "passes": {
        "soft": { "pass": "gaussian_blur", "inputs": { "image": "photo" } },
        "small": { "pass": "downsample", "inputs": { "image": "soft" } } }, "outputs": { "color": "small" } })"))
              .size() == 3);
}

TEST_CASE("a pass before one that is called is stored, whatever its extent", "[graphs][called]")
{
    const Graph graph = graph_of(R"({ "passgraph": 1, "inputs": { "photo": "radiance" }, "passes": {
        "dim": { "pass": "vignette", "inputs": { "image": "photo" } },
        "bright": { "pass": "bright", "inputs": { "image": "dim" } },
        "same": { "pass": "downsample", "inputs": { "image": "bright" }, "scale": [1, 1] },
        "edge": { "pass": "vignette", "inputs": { "image": "same" } } }, "outputs": { "color": "edge" } })");
    CHECK(names_of(graph) == std::vector<std::string>{"dim", "bright + same + edge"});
    GraphRun run;
    run.pictures = {{"photo", noise({31, 9}, 3, 0.0f, 4.0f, 330)}};
    run.options.extent = {31, 9};
    const Picture fused = run_graph(graph, run).at("color");
    run.options.fuse = false;
    const Picture apart = run_graph(graph, run).at("color");
    // Halves between the draws: two stores of 2^-10 each more, and what they move through the knee, of slope at most 2.
    CHECK(largest_difference(fused, apart) <= 4.0f * 4.0f * 3.0f / 1024.0f);
}
