// What is not drawn: surfaces and background apart by the depth test, steps whose images are there already.
#include <random>

#include <passgraph/scene/scene_file.hpp>

#include "graphs/graph_runner.hpp"
#include "support/catch.hpp"
#include "support/test_context.hpp"

using namespace passgraph;
using namespace passgraph::test;

namespace {

template <class T>
T must(Result<T> result)
{
    if (!result)
        FAIL(to_text(result.error()));
    if constexpr (!std::is_void_v<T>)
        return std::move(*result);
}

const Scene& night_lamp()
{
    static const Scene scene = must(load_scene(
        std::string(PASSGRAPH_SOURCE_DIR) + "/samples/deferred_demo/resources/scenes/night_lamp.scene.json"));
    return scene;
}

Renderer demo_renderer(const Graph& graph, const CompileOptions& options)
{
    Renderer renderer = must(Renderer::create(must(compile(graph, options)), {.loader = test_context().loader()}));
    must(renderer.set_scene(night_lamp()));
    return renderer;
}

std::int64_t draws_of(Renderer& renderer, const Frame& frame)
{
    const std::int64_t before = renderer.counters().draws;
    must(renderer.render(frame));
    return renderer.counters().draws - before;
}

} // namespace

TEST_CASE("drawing surfaces and background apart changes no bit", "[graphs][skipping]")
{
    for (const char* name : {"bloom", "pixelated", "night"}) {
        Graph graph = sample_graph(std::string("deferred_demo/") + name + ".graph.json");
        for (const char* image : {"lit", "view", "bright"})
            graph.output(image, AnyImage(*graph.find_image(image)));
        for (const bool fuses : {true, false}) {
            for (const Extent extent : {Extent{160, 90}, Extent{17, 13}, Extent{1, 1}}) {
                CAPTURE(name, fuses, extent.width);
                GraphRun run;
                run.scene = &night_lamp();
                run.options.extent = extent;
                run.options.fuse = fuses;
                const auto apart = run_graph(graph, run);
                const auto plan = must(compile(graph, run.options));
                CHECK(std::any_of(plan.steps.begin(), plan.steps.end(), [](const auto& step) { return !step.background.empty(); }));
                run.options.specialise = false;
                for (const auto& [output, picture] : run_graph(graph, run))
                    CHECK(picture.texels == apart.at(output).texels);
            }
        }
    }
}

TEST_CASE("a still camera draws nothing, a vignette's change one step, a moved camera all but what is constant", "[graphs][skipping]")
{
    Renderer renderer = demo_renderer(sample_graph("deferred_demo/night.graph.json"), {.extent = {64, 36}});
    const std::int64_t all = draws_of(renderer, {});
    CHECK(all > 5);
    CHECK(draws_of(renderer, {.index = 1}) == 0);
    std::string amount;
    for (const Plan::Uniform& uniform : renderer.plan().steps.back().uniforms)
        if (uniform.place.ends_with(".amount"))
            amount = uniform.place;
    REQUIRE(!amount.empty());
    must(renderer.set(amount, Value(0.25)));
    CHECK(draws_of(renderer, {.index = 2}) == 2); // one step in two variants, of which the device draws one
    must(renderer.set(amount, Value(0.25)));
    CHECK(draws_of(renderer, {.index = 3}) == 0);
    Camera moved = night_lamp().camera;
    moved.position.x += 1.0;
    CHECK(draws_of(renderer, {.index = 4, .camera = &moved}) == all - 1); // the split-sum table stays
    CHECK(draws_of(renderer, {.index = 5, .camera = &moved, .redraws = true}) == all - 1);
}

TEST_CASE("after any changes the pictures are those of a renderer that draws everything", "[graphs][skipping]")
{
    const Graph graph = sample_graph("deferred_demo/bloom.graph.json");
    const CompileOptions options{.extent = {48, 27}};
    Renderer lazy = demo_renderer(graph, options);
    std::mt19937 random(7);
    std::vector<const Plan::Uniform*> live;
    for (const Plan::Step& step : lazy.plan().steps)
        for (const Plan::Uniform& uniform : step.uniforms)
            if (uniform.type == ParamType::float_)
                live.push_back(&uniform);
    REQUIRE(live.size() > 4);
    std::map<std::string, Value> values;
    Camera camera = night_lamp().camera;
    const std::int64_t all = draws_of(lazy, {.camera = &camera});
    std::int64_t drawn = 0;
    for (int round = 0; round < 12; ++round) {
        const Plan::Uniform& chosen = *live[random() % live.size()];
        const Value value(chosen.lowest + 0.001 * static_cast<double>(random() % 1000) * (std::min(chosen.highest, 4.0) - chosen.lowest));
        values[chosen.place] = value;
        must(lazy.set(chosen.place, value));
        if (round % 4 == 3)
            camera.position.y += 3.0;
        drawn += draws_of(lazy, {.index = round, .camera = &camera});
        Renderer fresh = demo_renderer(graph, options);
        for (const auto& [place, kept] : values)
            must(fresh.set(place, kept));
        must(fresh.render({.camera = &camera}));
        CAPTURE(round, chosen.place);
        CHECK(must(lazy.read("color")).texels == must(fresh.read("color")).texels);
    }
    CHECK(drawn < 12 * all); // it did leave steps out
}
