// The four layouts of the G-buffer: the same values within what their codecs round.
#include <cmath>

#include <passgraph/scene/scene_file.hpp>

#include "graphs/graph_runner.hpp"
#include "support/catch.hpp"

using namespace passgraph;
using namespace passgraph::test;

namespace {

constexpr Extent kExtent{160, 90};

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

Graph with_layout(const std::string& layout)
{
    Graph graph = sample_graph("deferred_demo/bloom.graph.json");
    REQUIRE(graph.set("surface.layout", {.name = "layout", .numbers = {}, .item = layout, .where = {}}));
    return graph;
}

/// What lighting gets, by name.
std::map<std::string, Picture> surfaces(const std::string& layout)
{
    Graph graph = with_layout(layout);
    for (const char* output : {"albedo", "material", "normal", "position", "depth"})
        graph.output(output, AnyImage(*graph.find_image(std::string("surface.") + output)));
    GraphRun run;
    run.options.extent = kExtent;
    run.scene = &night_lamp();
    return run_graph(graph, run);
}

double angle(const float* a, const float* b)
{
    const double across = std::hypot(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]);
    return std::atan2(across, a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
}

double gap(const float* a, const float* b)
{
    double largest = 0.0;
    for (int c = 0; c < 3; ++c)
        largest = std::max(largest, std::abs(static_cast<double>(a[c]) - static_cast<double>(b[c])));
    return largest;
}

} // namespace

TEST_CASE("every layout hands lighting the same surfaces, within its codecs' rounding", "[graphs][layouts]")
{
    const auto plain = surfaces("four_target");
    for (const char* layout : {"two_target", "three_target", "packed_alpha"}) {
        const auto got = surfaces(layout);
        int seen = 0;
        for (int y = 0; y < kExtent.height; ++y) {
            for (int x = 0; x < kExtent.width; ++x) {
                CAPTURE(layout, x, y);
                const auto at = [&](const std::map<std::string, Picture>& from, const char* name) {
                    const Picture& picture = from.at(name);
                    return &picture.texels[picture.index(x, y)];
                };
                const bool is_surface = *at(plain, "depth") > 0.0f;
                REQUIRE((*at(got, "depth") > 0.0f) == is_surface);
                if (!is_surface)
                    continue;
                ++seen;
                const double distance = -static_cast<double>(at(plain, "position")[2]);
                // Octahedral 16 bit is at most 0.0037 degrees off, halves 0.0204; both roundings count.
                CHECK(angle(at(got, "normal"), at(plain, "normal")) <= (0.0037 + 0.0204) * 3.14159265 / 180.0);
                // Reversed depth rounds to 2^-24 of itself where near / z is all of it; window coordinates are the
                // rasteriser's own interpolation, 2^-16 of the distance (256 places in a pixel, measured slope below 1 / 256).
                CHECK(gap(at(got, "position"), at(plain, "position")) <= distance * 0x1p-16 + 1e-4);
                // A place in the atlas is rounded to 1 / 65535 of its 2196 texels: 0.017 of a texel each way, whose neighbours
                // differ by 1 at most; and a code of sRGB, at its steepest 2.4 / 1.055 / 255, from each side.
                const double place = 2.0 * 0.5 * 2196.0 / 65535.0;
                CHECK(gap(at(got, "albedo"), at(plain, "albedo")) <= place + 2.28 / 255.0);
                // 8 bits each, or a half's 2^-11 in the alphas.
                CHECK(gap(at(got, "material"), at(plain, "material")) <= place + 1.01 / 255.0);
            }
        }
        CHECK(seen > 5000);
    }
}

TEST_CASE("a G-buffer takes 12 bytes a pixel as two_target, 36 as four_target", "[graphs][layouts]")
{
    const auto bytes = [](const char* layout) {
        const auto plan = compile(with_layout(layout), {.extent = kExtent});
        REQUIRE(plan);
        int sum = 0;
        const Plan::Step& step = plan->steps.front();
        for (const Plan::Target& target : step.targets)
            sum += bytes_per_texel(plan->slots[static_cast<size_t>(target.slot)].format);
        return sum + bytes_per_texel(plan->slots[static_cast<size_t>(step.depth_slot)].format);
    };
    CHECK(bytes("two_target") == 12);
    CHECK(bytes("four_target") == 36);
    CHECK(bytes("packed_alpha") == 36);
    CHECK(bytes("three_target") == 40);
}
