// Hard cases of screen effects, luminance and the noise that passes may ask for.
#include <cmath>
#include <limits>

#include <passgraph/shader/pass_file.hpp>

#include "graphs/graph_runner.hpp"
#include "support/catch.hpp"
#include "support/pass_runner.hpp"

using namespace passgraph;
using namespace passgraph::test;

TEST_CASE("a cell of 0, below 1 or endless is refused, and one larger than the picture is its middle", "[catalogue][screen]")
{
    for (const double cell : {0.0, 0.5, -1.0, 1e9, std::numeric_limits<double>::quiet_NaN()}) {
        Graph graph;
        PassArguments arguments;
        arguments.inputs = {{"image", graph.picture<Display>("image")}};
        PassArguments::Setting setting;
        setting.name = "cell";
        setting.numbers = {cell};
        arguments.settings = {setting};
        graph.output("out", graph.add("pixelate", std::move(arguments))["color"]);
        const auto plan = compile(graph);
        INFO(cell);
        REQUIRE_FALSE(plan);
        CHECK(plan.error().front().code == "param_out_of_range");
    }
    Picture picture = constant({5, 3}, {0.0f, 0.0f, 0.0f});
    picture.at(2, 1, 1) = 1.0f;
    const Picture cells = run_for_output({.pass = "pixelate", .inputs = {{"image", picture}}, .settings = {{"cell", "512"}}});
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 5; ++x)
            CHECK(cells.at(x, y, 1) == 1.0f);
}

TEST_CASE("a cell whose middle is no number is black, and no other cell differs", "[catalogue][screen]")
{
    Picture picture = noise({15, 9}, 3, 0.1f, 1.0f, 84);
    const std::vector<std::pair<std::string, std::string>> cell = {{"cell", "3"}};
    const Picture before = run_for_output({.pass = "pixelate", .inputs = {{"image", picture}}, .settings = cell});
    for (int c = 0; c < 3; ++c)
        picture.at(4, 4, c) = std::numeric_limits<float>::quiet_NaN(); // the middle of the second cell of the second row
    const Picture after = run_for_output({.pass = "pixelate", .inputs = {{"image", picture}}, .settings = cell});
    for (int y = 0; y < 9; ++y)
        for (int x = 0; x < 15; ++x) {
            const bool is_hit = x / 3 == 1 && y / 3 == 1;
            CHECK(after.at(x, y, 0) == (is_hit ? 0.0f : before.at(x, y, 0)));
        }
}

TEST_CASE("cells before bloom and bloom before cells are two pictures, and the graph says which", "[catalogue][screen]")
{
    const auto chain = [](const std::string& first, const std::string& second) {
        const auto step = [](const std::string& name, const std::string& from) {
            return name == "cells" ? "\"cells\": { \"pass\": \"pixelate\", \"inputs\": { \"image\": \"" + from + "\" }, \"params\": { \"cell\": 4 } }"
                                   : "\"glow\": { \"pass\": \"gaussian_blur\", \"inputs\": { \"image\": \"" + from + "\" } }";
        };
        return graph_of("{ \"passgraph\": 1, \"inputs\": { \"scene\": \"radiance\" }, \"passes\": { " + step(first, "scene") + ", " + step(second, first) +
                        " }, \"outputs\": { \"color\": \"" + second + "\" } }");
    };
    const GraphRun run{.pictures = {{"scene", noise({16, 12}, 3, 0.0f, 4.0f, 85)}}};
    const Picture cells_last = run_graph(chain("glow", "cells"), run).at("color");
    const Picture glow_last = run_graph(chain("cells", "glow"), run).at("color");
    for (int x = 1; x < 4; ++x)
        CHECK(cells_last.at(x, 0, 0) == cells_last.at(0, 0, 0)); // cells stay sharp where they come last
    CHECK(glow_last.at(3, 0, 0) != glow_last.at(0, 0, 0));
    CHECK(largest_difference(cells_last, glow_last) > 0.01f);
}

TEST_CASE("white has a luminance of 1, and each grey its own", "[catalogue][screen]")
{
    for (const auto& row : evaluate("luminance(vec3(x)) - x", {"luminance.glsl"}, {"x"}, {{0.0f}, {0.25f}, {1.0f}, {1000.0f}}))
        CHECK(std::abs(row[0]) <= 1000.0f * 3.0f / 16777216.0f); // three products, rounded
    CHECK(evaluate("luminance(vec3(1.0))", {"luminance.glsl"}, {"x"}, {{0.0f}})[0][0] == Approx(1.0f).epsilon(2e-7));
}

TEST_CASE("random numbers are even, and the same for the same pixel and frame", "[catalogue][screen]")
{
    PassLibrary library = builtin_passes();
    const auto pass = read_pass(R"(/*{ "pass": "grain", "summary": "", "source": "", "reads": ["frame"], "inputs": { "image": "display" },
  "outputs": { "color": "display" } }*/
vec3 grain(vec2 uv) { return image(uv) * 0.0 + vec3(random(pixel(), frame_index()), random(pixel(), frame_index() + 1), fract(frame_time())); }
)",
                                "grain.glsl", "test", {});
    REQUIRE(pass);
    library.add(*pass);
    const Graph graph = graph_of(R"({ "passgraph": 1, "inputs": { "image": "display" },
  "passes": { "grain": { "pass": "grain", "inputs": { "image": "image" }, "codecs": { "color": "rgba32f" } } }, "outputs": { "color": "grain" } })",
                                 library);
    const GraphRun run{.pictures = {{"image", constant({64, 64}, {0.0f, 0.0f, 0.0f})}}};
    const Picture first = run_graph(graph, run).at("color");
    CHECK(largest_difference(first, run_graph(graph, run).at("color")) == 0.0f);
    std::array<int, 16> bins{};
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            ++bins[static_cast<size_t>(first.at(x, y, 0) * 16.0f)];
    // 4096 draws into 16 bins: 256 each, with a deviation of sqrt(256 * 15 / 16) = 15.5; five of them either way.
    for (const int count : bins)
        CHECK(std::abs(count - 256) <= 78);
}
