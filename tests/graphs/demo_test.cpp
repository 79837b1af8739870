// The demo's three stacks and the photo stack, end to end.
#include <cmath>

#include <passgraph/scene/scene_file.hpp>

#include "graphs/graph_runner.hpp"
#include "support/catch.hpp"
#include "support/pass_runner.hpp"

using namespace passgraph;
using namespace passgraph::test;

namespace {

const Scene& night_lamp()
{
    static const Scene scene = [] {
        auto loaded = load_scene(std::string(PASSGRAPH_SOURCE_DIR) +
                                 "/samples/deferred_demo/resources/scenes/night_lamp.scene.json");
        if (!loaded)
            FAIL(to_text(loaded.error()));
        return std::move(*loaded);
    }();
    return scene;
}

Picture demo_picture(const std::string& graph, Extent extent)
{
    GraphRun run;
    run.options.extent = extent;
    run.scene = &night_lamp();
    return run_graph(sample_graph("deferred_demo/" + graph), run).at("color");
}

/// The mean color of a box, in parts of the picture's width and height from the bottom left.
std::array<double, 3> mean(const Picture& picture, double left, double bottom, double right, double top)
{
    std::array<double, 3> sum{};
    int count = 0;
    for (int y = static_cast<int>(bottom * picture.extent.height); y < static_cast<int>(top * picture.extent.height);
         ++y) {
        for (int x = static_cast<int>(left * picture.extent.width); x < static_cast<int>(right * picture.extent.width);
             ++x) {
            for (int c = 0; c < 3; ++c)
                sum[static_cast<size_t>(c)] += picture.at(x, y, c);
            ++count;
        }
    }
    for (double& channel : sum)
        channel /= count;
    return sum;
}

constexpr Extent kExtent{320, 180};

} // namespace

TEST_CASE("the bloom stack shows the scene: night sky, stone floor, red sphere, glowing lantern", "[graphs][demo]")
{
    const Picture picture = demo_picture("bloom.graph.json", kExtent);
    const auto sky = mean(picture, 0.02, 0.85, 0.5, 0.98);
    const auto sphere = mean(picture, 0.44, 0.30, 0.52, 0.45);
    const auto lantern = mean(picture, 0.705, 0.47, 0.735, 0.54);
    const auto near_lamp = mean(picture, 0.66, 0.10, 0.80, 0.20);
    const auto far_left = mean(picture, 0.02, 0.10, 0.16, 0.20);
    CHECK(sky[2] > sky[0]);                                               // blue
    CHECK(sky[2] < 0.35);                                                 // and dark
    CHECK(sphere[0] > 4.0 * sphere[1]);                                   // red
    CHECK(lantern[0] > 0.7);                                              // bright
    CHECK(lantern[0] > 1.3 * lantern[2]);                                 // and warm
    CHECK(near_lamp[0] / near_lamp[2] > 1.5 * far_left[0] / far_left[2]); // the lamp's light on the stones is warm too
}

TEST_CASE("bloom reaches past the lantern's panes", "[graphs][demo]")
{
    GraphRun run;
    run.options.extent = kExtent;
    run.scene = &night_lamp();
    run.options.specialise = false; // without its bloom the frame is one draw less, and rounded once less
    Graph with = sample_graph("deferred_demo/bloom.graph.json");
    Graph without = sample_graph("deferred_demo/bloom.graph.json");
    REQUIRE(without.set("film.strength", {"", {0.0}, "", {}}));
    const Picture lit = run_graph(with, run).at("color");
    const Picture dull = run_graph(without, run).at("color");
    int brighter = 0;
    for (size_t i = 0; i < lit.texels.size(); ++i) {
        CHECK(lit.texels[i] >= dull.texels[i]); // glow only adds
        brighter += lit.texels[i] > dull.texels[i] + 0.02f;
    }
    CHECK(brighter > 200);
}

TEST_CASE("the pixelated stack is uniform inside each cell", "[graphs][demo]")
{
    const Picture picture = demo_picture("pixelated.graph.json", kExtent);
    constexpr int kCell = 9; // as the graph file says
    for (int y = 0; y < kExtent.height; ++y)
        for (int x = 0; x < kExtent.width; ++x)
            for (int c = 0; c < 3; ++c)
                if (picture.at(x, y, c) != picture.at(x / kCell * kCell, y / kCell * kCell, c))
                    FAIL("texel " << x << ", " << y << " differs from its cell");
    // Cells do differ from one another.
    CHECK(picture.at(0, 0, 2) != picture.at(160, 90, 2));
}

TEST_CASE("the night stack is green, darker towards the corners, and never negative", "[graphs][demo]")
{
    const Picture bloom = demo_picture("bloom.graph.json", kExtent);
    const Picture night = demo_picture("night.graph.json", kExtent);
    const auto whole = mean(night, 0.0, 0.0, 1.0, 1.0);
    CHECK(whole[1] > whole[0]);
    CHECK(whole[1] > whole[2]);
    const auto corner = mean(night, 0.0, 0.0, 0.04, 0.04);
    const auto corner_before = mean(bloom, 0.0, 0.0, 0.04, 0.04);
    CHECK(corner[1] <= 0.02 + 0.1 * corner_before[1]);
    for (const float value : night.texels) {
        CHECK(value >= 0.0f);
        CHECK(value <= 1.0f);
    }
}

TEST_CASE("the demo creates no GL object after its first frame, and its frames are equal", "[graphs][demo]")
{
    for (const char* name : {"bloom.graph.json", "pixelated.graph.json", "night.graph.json"}) {
        GraphRun run;
        run.options.extent = {64, 36};
        run.scene = &night_lamp();
        run.frames = 4;
        std::vector<Renderer::Counters> counters;
        const Picture fourth =
            run_graph(sample_graph(std::string("deferred_demo/") + name), run, &counters).at("color");
        CHECK(counters.back().objects_created == counters.front().objects_created);
        run.frames = 1;
        const Picture first = run_graph(sample_graph(std::string("deferred_demo/") + name), run).at("color");
        CHECK(largest_difference(first, fourth) == 0.0f);
    }
}

TEST_CASE("the demo survives the smallest and oddest extents", "[graphs][demo]")
{
    for (const Extent extent : {Extent{1, 1}, Extent{1, 64}, Extent{64, 1}, Extent{17, 13}})
        for (const char* name : {"bloom.graph.json", "pixelated.graph.json", "night.graph.json"})
            for (const Picture picture = demo_picture(name, extent); const float value : picture.texels) {
                CHECK(value >= 0.0f);
                CHECK(value <= 1.0f);
            }
}

TEST_CASE("the lighting, the sky and the bright pass are one step; where nobody else looks, bright is computed where it is averaged", "[graphs][demo]")
{
    Graph graph = sample_graph("deferred_demo/bloom.graph.json");
    const auto called = compile(graph);
    REQUIRE(called);
    REQUIRE(called->steps.size() == 7);
    CHECK(called->steps[2].name == "surface.surface_from_atlas + surface.position_from_depth + lit.surface + view");
    CHECK(called->steps[3].name == "bright + eighth");
    graph.output("bright", AnyImage(*graph.find_image("bright")));
    const auto plan = compile(graph);
    REQUIRE(plan);
    REQUIRE(plan->steps.size() == 7);
    CHECK(plan->steps[1].name == "lit.share"); // the split-sum table, which reads nothing
    CHECK(plan->steps[2].name == "surface.surface_from_atlas + surface.position_from_depth + lit.surface + view + bright");
}

TEST_CASE("the photo stack brightens, glows and frames any picture", "[graphs][photo]")
{
    Picture photo = constant({48, 32}, {0.05f, 0.05f, 0.05f});
    for (int y = 14; y < 18; ++y)
        for (int x = 22; x < 26; ++x)
            for (int c = 0; c < 3; ++c)
                photo.at(x, y, c) = 6.0f;
    GraphRun run;
    run.options.extent = photo.extent;
    run.pictures = {{"photo", photo}};
    const Picture shown = run_graph(sample_graph("photo_stack/photo_stack.graph.json"), run).at("color");
    CHECK(shown.extent == photo.extent);
    CHECK(shown.at(24, 16) > 0.9f);                     // the lamp
    CHECK(shown.at(29, 16) > shown.at(40, 16) + 0.01f); // its glow
    CHECK(shown.at(0, 0) < shown.at(12, 16));           // the corner
}
