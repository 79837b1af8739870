// What the compiler checks of a graph: signals, domains, extents, codecs.
#include <limits>

#include <passgraph/core/graph_file.hpp>

#include "core_support.hpp"
#include "support/catch.hpp"

using namespace passgraph;
using namespace passgraph::test;
using Catch::Contains;

namespace {

constexpr Access kPointwise = {AccessClass::pointwise, 0};

PassLibrary small_library()
{
    PassLibrary library;
    library.add(PassMaker("copy").input("image", kPointwise).output("color").done());
    library.add(PassMaker("mixed").input("one", kPointwise).input("two", kPointwise).output("color").done());
    library.add(PassMaker("half").input("image", kPointwise).output("color", Signal::color, {1, 2}).done());
    library.add(PassMaker("tone").input("image", kPointwise, Signal::radiance).output("color", Signal::display).done());
    PassMaker fixed("fixed");
    fixed.input("image", kPointwise).output("color");
    fixed.pass.outputs[0].texels = {{7, 3}};
    library.add(fixed.done());
    PassMaker like("like");
    like.input("image", kPointwise).input("other", kPointwise).output("color");
    like.pass.outputs[0].size_of = "other";
    like.pass.outputs[0].scale = {2, 3};
    library.add(like.done());
    library.add(PassMaker("noise").output("color", Signal::radiance).done());
    library.add(PassMaker("far").input("image", kPointwise).output("depth", Signal::depth).done());
    return library;
}

PassArguments reading(AnyImage image, std::optional<Ratio> scale = {}, const char* port = "image")
{
    PassArguments arguments;
    arguments.inputs.push_back({port, image});
    arguments.scale = scale;
    return arguments;
}

Extent extent_of(const Graph& graph, const CompileOptions& options) { return planned(graph, options).outputs.front().extent; }

} // namespace

TEST_CASE("a wire of the wrong signal names both ends and a fix", "[core][validate]")
{
    const auto description = read_graph_description(R"({ "passgraph": 1, "inputs": { "photo": "radiance" }, "passes": {
  "lit": { "pass": "bright", "inputs": { "image": "photo" } },
  "toned": { "pass": "tone_map", "inputs": { "image": "lit" } },
  "film": { "pass": "bloom_combine", "inputs": { "scene": "toned", "bloom": "lit" } },
  "green": { "pass": "night_vision", "inputs": { "image": "lit" } } },
  "outputs": { "color": "film" } })", "stack.graph.json");
    REQUIRE(description);
    const auto plan = compile(build_graph(*description, builtin_passes()));
    REQUIRE(!plan);
    REQUIRE(plan.error().size() == 2);
    CHECK(to_text(plan.error()[0]) == "stack.graph.json:4:59: error[signal_mismatch] film.scene: expects radiance, got display from toned\n"
                                      "  hint: read lit, or put `film` before the tone map");
    CHECK(plan.error()[1].message == "green.image: expects display, got radiance from lit");
    CHECK(plan.error()[1].hint == "read toned");
}

TEST_CASE("without an image that fits, the pass that makes one is named", "[core][validate]")
{
    Graph graph;
    const auto photo = graph.picture<Radiance>("photo");
    graph.output("color", graph.add("night_vision", reading(photo))[""]);
    const auto plan = compile(graph);
    REQUIRE(!plan);
    CHECK(plan.error().front().hint == "put a tone_map between them");
}

TEST_CASE("an input that nothing is wired to is missing, unless it is optional", "[core][validate]")
{
    Graph graph;
    graph.output("color", graph.add("tone_map", {})[""]);
    const auto plan = compile(graph);
    REQUIRE(!plan);
    CHECK(plan.error().front().code == "input_missing");
    CHECK(plan.error().front().message == "tone_map.image: nothing is wired to it");
    CHECK(plan.error().front().hint == "wire an image of signal radiance to it");
}

TEST_CASE("all generic inputs of a pass carry one signal", "[core][validate]")
{
    const PassLibrary library = small_library();
    Graph graph(library);
    const auto photo = graph.picture<Radiance>("photo");
    const auto code = graph.picture<Display>("code");
    PassArguments both = reading(photo, {}, "one");
    both.inputs.push_back({"two", code});
    graph.output("color", graph.add("mixed", both)[""]);
    const auto plan = compile(graph);
    REQUIRE(!plan);
    CHECK(plan.error().front().code == "generic_mismatch");
    CHECK_THAT(plan.error().front().message, Contains("mixed.two: got display from code") && Contains("is radiance"));
}

TEST_CASE("a generic output is what its input was", "[core][validate]")
{
    const PassLibrary library = small_library();
    for (const Signal signal : {Signal::radiance, Signal::radiance_alpha, Signal::display, Signal::display_alpha}) {
        Graph graph(library);
        graph.output("color", graph.add("copy", reading(graph.picture("photo", signal)))[""]);
        CHECK(planned(graph).outputs.front().signal == signal);
        CHECK(planned(graph).outputs.front().codec == codecs_of(signal).front());
    }
    Graph graph(library);
    graph.output("color", graph.add("copy", reading(graph.picture("photo", Signal::normal)))[""]);
    CHECK(codes_of(compile(graph)) == "signal_mismatch 0:0\n");
}

TEST_CASE("an output is an image", "[core][validate]")
{
    Graph graph;
    graph.output("color", graph.scene().sky);
    CHECK(codes_of(compile(graph)) == "over_mismatch 0:0\n");
    Graph empty;
    CHECK(codes_of(compile(empty)) == "output_missing 0:0\n");
    Graph twice;
    const auto photo = twice.picture<Radiance>("photo");
    twice.output("color", photo);
    twice.output("color", photo);
    CHECK(codes_of(compile(twice)) == "duplicate_name 0:0\n");
}

TEST_CASE("an extent is max(1, ceil(n p / q)) of the largest input", "[core][validate]")
{
    const PassLibrary library = small_library();
    struct Row {
        Extent from;
        Ratio scale;
        Extent to;
    };
    for (const Row& row : std::vector<Row>{{{17, 13}, {1, 2}, {9, 7}}, {{16, 12}, {1, 2}, {8, 6}}, {{1, 1}, {1, 2}, {1, 1}}, {{1, 5}, {1, 8}, {1, 1}},
                                           {{17, 13}, {2, 3}, {12, 9}}, {{17, 13}, {3, 1}, {51, 39}}, {{3, 3}, {65536, 65536}, {3, 3}}, {{7, 7}, {1, 65536}, {1, 1}}}) {
        Graph graph(library);
        graph.output("color", graph.add("copy", reading(graph.picture<Radiance>("photo"), row.scale))[""]);
        CHECK(extent_of(graph, {.picture_extents = {{"photo", row.from}}}) == row.to);
    }
    Graph graph(library);
    PassArguments both = reading(graph.picture<Radiance>("small"), {}, "one");
    both.inputs.push_back({"two", graph.picture<Radiance>("large")});
    graph.output("color", graph.add("mixed", both)[""]);
    CHECK(extent_of(graph, {.picture_extents = {{"small", {8, 8}}, {"large", {9, 8}}}}) == Extent{9, 8});
}

TEST_CASE("an extent may be fixed, that of an input, that of another image, or the frame's", "[core][validate]")
{
    const PassLibrary library = small_library();
    const CompileOptions options = {.extent = {40, 30}, .picture_extents = {{"small", {9, 6}}, {"large", {100, 50}}}};
    const auto extent_with = [&](const auto& make) {
        Graph graph(library);
        const auto small = graph.picture<Radiance>("small");
        const auto large = graph.picture<Radiance>("large");
        graph.output("color", make(graph, small, large));
        return extent_of(graph, options);
    };
    CHECK(extent_with([](Graph& graph, AnyImage small, AnyImage) { return graph.add("fixed", reading(small))[""]; }) == Extent{7, 3});
    CHECK(extent_with([](Graph& graph, AnyImage small, AnyImage large) {
              PassArguments both = reading(large);
              both.inputs.push_back({"other", small});
              return graph.add("like", both)[""];
          }) == Extent{6, 4});
    CHECK(extent_with([](Graph& graph, AnyImage small, AnyImage large) {
              PassArguments sized = reading(large);
              sized.size_of = small;
              return graph.add("half", sized)[""];
          }) == Extent{9, 6});
    CHECK(extent_with([](Graph& graph, AnyImage, AnyImage) { return graph.add("noise", {})[""]; }) == Extent{40, 30});
    CHECK(extent_with([](Graph& graph, AnyImage, AnyImage large) { return graph.add("half", reading(large, Ratio{1, 4}))[""]; }) == Extent{25, 13});
}

TEST_CASE("an extent beyond the device is a lack of the machine, an empty one a mistake", "[core][validate]")
{
    const PassLibrary library = small_library();
    Graph graph(library);
    graph.output("color", graph.add("copy", reading(graph.picture<Radiance>("photo"), Ratio{2, 1}))[""]);
    const auto large = compile(graph, {.picture_extents = {{"photo", {600, 5}}}, .device = {1024, 16, 8}});
    REQUIRE(!large);
    REQUIRE(large.error().size() == 1);
    CHECK(large.error().front().code == "extent_too_large");
    CHECK(large.error().front().fault == Fault::machine);
    CHECK_THAT(to_text(large.error().front()), Contains("1200x10") && Contains("1024"));
    CHECK(compile(graph, {.picture_extents = {{"photo", {512, 5}}}, .device = {1024, 16, 8}}));
    const auto empty = compile(graph, {.picture_extents = {{"photo", {0, 5}}}});
    REQUIRE(!empty);
    CHECK(empty.error().front().code == "extent_empty");
    CHECK(empty.error().front().fault == Fault::user);
    const auto huge = compile(graph, {.picture_extents = {{"photo", {std::numeric_limits<int>::max(), 5}}}});
    REQUIRE(!huge);
    CHECK(huge.error().back().code == "extent_too_large");
}

TEST_CASE("a generic output's codec is checked against what flows there", "[core][validate]")
{
    const PassLibrary library = small_library();
    const auto stored_as = [&](Signal signal, const std::string& codec) {
        Graph graph(library);
        PassArguments arguments = reading(graph.picture("photo", signal));
        arguments.codecs.push_back({"color", {}, codec, {}});
        graph.output("color", graph.add("copy", arguments)[""]);
        return compile(graph);
    };
    CHECK(stored_as(Signal::display, "rgb10_a2")->outputs.front().codec.format == Format::rgb10_a2);
    CHECK(codes_of(stored_as(Signal::radiance, "rgb10_a2")) == "unknown_codec 0:0\n");
    CHECK(codes_of(stored_as(Signal::radiance_alpha, "r11f_g11f_b10f")) == "unknown_codec 0:0\n");
}

TEST_CASE("only geometry has a depth buffer: a full-screen pass stores depth as a color", "[core][validate]")
{
    const PassLibrary library = small_library();
    Graph graph(library);
    PassArguments arguments = reading(graph.picture<Radiance>("photo"));
    graph.output("depth", graph.add("far", arguments)[""]);
    const Plan plan = planned(graph);
    CHECK(plan.steps.front().depth_slot == -1);
    REQUIRE(plan.steps.front().targets.size() == 1);
    CHECK(plan.slots.front().format == Format::r32f);
    CHECK(graph.set_codec("far", "depth24"));
    CHECK(codes_of(compile(graph)) == "unknown_codec 0:0\n");
    Graph drawn;
    PassArguments surface;
    surface.inputs.push_back({"scene", drawn.scene().elements});
    surface.codecs.push_back({"depth", {}, "r32f", {}});
    drawn.output("depth", drawn.add("gbuffer", surface)["depth"]);
    const Plan own = planned(drawn); // a color holds what is read, a depth buffer of its own what is tested against
    CHECK(own.slots[static_cast<size_t>(own.steps.front().depth_slot)].format == Format::depth32f);
    CHECK(own.slots[static_cast<size_t>(own.outputs.front().index)].format == Format::r32f);
}

TEST_CASE("mistakes made in C++ are kept and come back together", "[core][validate]")
{
    Graph graph;
    const auto photo = graph.picture<Radiance>("photo");
    graph.picture<Radiance>("photo");
    graph.add("tonemap", reading(photo));
    graph.output("color", graph.add("tone_map", reading(photo))["colour"]);
    const auto plan = compile(graph);
    REQUIRE(!plan);
    CHECK(codes_of(plan) == "duplicate_name 0:0\nunknown_pass 0:0\nunknown_image 0:0\n");
    Graph numbered;
    const auto picture = numbered.picture<Radiance>("photo");
    const auto first = numbered.add("bright", reading(picture))[""];
    numbered.output("color", numbered.add("bright", reading(first))[""]);
    CHECK(numbered.find_node("bright_2") >= 0); // unnamed passes are numbered, not mistaken for one another
    CHECK(compile(numbered));
}
