// Whole graphs whose textures start as NaN, drawn by a host that leaves GL state in disorder: not one bit may differ.
#include <cstdlib>
#include <cstring>
#include <optional>

#include <passgraph/core/graph_file.hpp>
#include <passgraph/gl/renderer.hpp>
#include <passgraph/scene/scene_file.hpp>

#include "support/dirty_state.hpp"
#include "contract/random_picture_graph.hpp"
#include "support/catch.hpp"
#include "support/test_context.hpp"

using namespace passgraph;
using namespace passgraph::test;

namespace {

/// Many small programs: softpipe compiles them twenty times as fast. Set before the first context is made.
const bool kUsesSoftpipe = setenv("GALLIUM_DRIVER", "softpipe", 0) == 0;

template <class T>
T expect(Result<T> result)
{
    if (!result)
        FAIL(to_text(result.error()));
    if constexpr (!std::is_void_v<T>)
        return std::move(*result);
}

struct Drawn {
    const Graph& graph;
    CompileOptions options;
    std::map<std::string, Picture> pictures{};
    const Scene* scene = nullptr;
    int frames = 2;
};

/// Every output after the last frame, in the graph's order.
std::vector<Picture> draw(Drawn drawn, const RendererOptions& device)
{
    for (const auto& [name, picture] : drawn.pictures)
        drawn.options.picture_extents[name] = picture.extent;
    Renderer renderer = expect(Renderer::create(expect(compile(drawn.graph, drawn.options)), device));
    if (drawn.scene)
        expect(renderer.set_scene(*drawn.scene));
    for (const Plan::Import& import : renderer.plan().imports)
        if (const auto picture = drawn.pictures.find(import.name); picture != drawn.pictures.end())
            expect(renderer.import_picture(import.name, picture->second));
    for (int frame = 0; frame < drawn.frames; ++frame) {
        Frame now;
        now.index = frame;
        now.redraws = true;
        expect(renderer.render(now));
    }
    std::vector<Picture> outputs;
    for (const GraphOutput& output : drawn.graph.outputs())
        outputs.push_back(expect(renderer.read(output.name)));
    return outputs;
}

bool is_equal(const std::vector<Picture>& a, const std::vector<Picture>& b)
{
    if (a.size() != b.size())
        return false;
    for (size_t i = 0; i < a.size(); ++i)
        if (a[i].extent != b[i].extent ||
            std::memcmp(a[i].texels.data(), b[i].texels.data(), a[i].texels.size() * sizeof(float)) != 0)
            return false;
    return true;
}

struct Way {
    bool fuse = true;
    bool alias = true;
};

/// Clean, poisoned, and poisoned and dirtied: the same bits, whatever the compiler does.
void check_ways(const Drawn& drawn, unsigned seed, const std::vector<Way>& ways)
{
    const GlLoader loader = test_context().loader();
    const RendererOptions clean{.loader = loader};
    RendererOptions poisoned = clean;
    poisoned.is_poisoned = true;
    for (const Way& way : ways) {
        Drawn this_way = drawn;
        this_way.options.fuse = way.fuse;
        this_way.options.alias = way.alias;
        INFO("fuse " << way.fuse << ", alias " << way.alias);
        const std::vector<Picture> expected = draw(this_way, clean);
        if (drawn.frames > 1) // else disorder and poison at once are enough
            CHECK(is_equal(draw(this_way, poisoned), expected));
        DirtyState dirty(loader, seed);
        RendererOptions disturbed = poisoned;
        disturbed.before_step = [&] { dirty(); };
        CHECK(is_equal(draw(this_way, disturbed), expected));
    }
}

Graph sample_graph(const std::string& name)
{
    return expect(load_graph(std::string(PASSGRAPH_SOURCE_DIR) + "/samples/deferred_demo/" + name, builtin_passes()));
}

const Scene& demo_scene()
{
    static const Scene scene =
        expect(load_scene(std::string(PASSGRAPH_SOURCE_DIR) + "/samples/deferred_demo/resources/scenes/night_lamp.scene.json"));
    return scene;
}

} // namespace

TEST_CASE("the demo's three graphs read nothing unwritten and rely on no state left behind", "[contract][poison][demo]")
{
    for (const char* name : {"bloom.graph.json", "night.graph.json", "pixelated.graph.json"}) {
        INFO(name);
        Graph graph = sample_graph(name);
        graph.output("lit", AnyImage(*graph.find_image("lit"))); // whose background nobody else reads
        Drawn drawn{.graph = graph, .options = {}};
        drawn.options.extent = {41, 27};
        drawn.scene = &demo_scene();
        drawn.frames = 1; // its table of integrals takes a second each time
        check_ways(drawn, 7, {{true, true}, {false, false}});
    }
}

TEST_CASE("random graphs read nothing unwritten and rely on no state left behind", "[contract][poison]")
{
    for (unsigned seed = 0; seed < 25; ++seed) {
        INFO("seed " << seed);
        const PictureGraph made = random_picture_graph(seed);
        check_ways({.graph = made.graph, .options = {}, .pictures = made.pictures}, seed,
                   {{true, true}, {true, false}, {false, true}, {false, false}});
    }
}

TEST_CASE("poison and disorder show in a picture that is not redrawn properly", "[contract][poison]")
{
    // The tests above would pass without effect if neither reached the picture: a step that never runs leaves its poison.
    const PictureGraph made = random_picture_graph(1);
    CompileOptions options;
    for (const auto& [name, picture] : made.pictures)
        options.picture_extents[name] = picture.extent;
    RendererOptions device{.loader = test_context().loader()};
    device.is_poisoned = true;
    Plan plan = expect(compile(made.graph, options));
    plan.steps.clear();
    Renderer renderer = expect(Renderer::create(std::move(plan), device));
    for (const auto& [name, picture] : made.pictures)
        for (const Plan::Import& import : renderer.plan().imports)
            if (import.name == name)
                expect(renderer.import_picture(name, picture));
    expect(renderer.render());
    const Picture unwritten = expect(renderer.read("out0"));
    CHECK(std::isnan(unwritten.at(0, 0, 0)));
    CHECK(std::isnan(unwritten.at(unwritten.extent.width - 1, unwritten.extent.height - 1, 2)));
}
