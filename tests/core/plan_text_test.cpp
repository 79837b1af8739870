// The plan as people and tools read it.
#include <nlohmann/json.hpp>

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
    PassMaker lift("lift");
    lift.input("image", kPointwise, Signal::radiance).output("color", Signal::radiance);
    Param amount;
    amount.name = "amount";
    amount.default_value = Value(0.5);
    amount.lowest = 0.0;
    lift.pass.params = {amount};
    library.add(lift.done());
    library.add(PassMaker("blur").input("image", {AccessClass::gather, 2}, Signal::radiance).output("color", Signal::radiance).done());
    library.add(PassMaker("tone").input("image", kPointwise, Signal::radiance).output("color", Signal::display).done());
    library.add(PassMaker("lonely").input("image", kPointwise, Signal::radiance).output("color", Signal::radiance).done());
    return library;
}

/// photo -> lift -> blur -> blur_2 -> tone -> out, with one pass that nobody reads.
Graph small_graph(const PassLibrary& library)
{
    Graph graph(library);
    const auto add = [&](const char* pass, AnyImage image) {
        PassArguments arguments;
        arguments.inputs.push_back({"image", image});
        return graph.add(pass, arguments)[""];
    };
    const AnyImage lifted = add("lift", graph.picture<Radiance>("photo"));
    add("lonely", lifted);
    graph.output("color", add("tone", add("blur", add("blur", lifted))));
    return graph;
}

const CompileOptions kOptions = {.extent = {512, 256}, .picture_extents = {{"photo", {512, 256}}}};

} // namespace

TEST_CASE("a plan reads as steps, slots, reasons and outputs", "[core][plan]")
{
    const PassLibrary library = small_library();
    CHECK(to_text(planned(small_graph(library), kOptions)) == R"(plan for 512x256: 3 steps, 3 slots, 2.5 MB (2.5 MB without sharing)
steps
  1. lift  512x256
       reads   photo (import, nearest)
       writes  lift (slot 0 rgba16f)
       live    lift.amount: a change concerns 3 of 3 steps
  2. blur  512x256
       reads   lift (slot 0, nearest)
       writes  blur (slot 1 rgba16f)
  3. blur_2 + tone  512x256
       reads   blur (slot 1, nearest)
       writes  tone (slot 2 rgba8)
slots
  0. rgba16f 512x256  lift
  1. rgba16f 512x256  blur
  2. rgba8 512x256  tone
kept in registers
  blur_2
kept in memory, because
  lift -> blur: blur.image reads it as gather(2)
  blur -> blur_2: blur_2.image reads it as gather(2)
not run
  lonely: no output needs it
outputs
  color: tone as display rgba8, 512x256
)");
}

TEST_CASE("a plan as a digraph follows each image from its step to its readers", "[core][plan]")
{
    const PassLibrary library = small_library();
    CHECK(to_dot(planned(small_graph(library), kOptions)) == R"(digraph plan {
  rankdir=LR;
  node [shape=box, fontname="sans-serif"];
  import0 [label="photo", shape=ellipse];
  step0 [label="1. lift"];
  step1 [label="2. blur"];
  step2 [label="3. blur_2 + tone"];
  import0 -> step0 [label="photo"];
  step0 -> step1 [label="lift"];
  step1 -> step2 [label="blur"];
  output0 [label="color", shape=ellipse];
  step2 -> output0;
}
)");
}

TEST_CASE("without fusion the last blur may take the first one's memory", "[core][plan]")
{
    const PassLibrary library = small_library();
    CompileOptions options = kOptions;
    options.fuse = false;
    const Plan plan = planned(small_graph(library), options);
    REQUIRE(plan.slots.size() == 3);
    CHECK(plan.slots[0].images == std::vector<std::string>{"lift", "blur_2"});
    CHECK(plan.bytes == 512 * 256 * (8 + 8 + 4));
    CHECK(plan.bytes_unshared == 512 * 256 * (8 + 8 + 8 + 4));
    for (const Plan::Boundary& boundary : plan.boundaries)
        CHECK(boundary.reason == "fusion is off");
    CHECK_THAT(to_text(plan), Contains("0. rgba16f 512x256  lift, then blur_2"));
    options.alias = false;
    CHECK(planned(small_graph(library), options).slots.size() == 4);
}

TEST_CASE("a plan as JSON is complete, and holds GLSL only when asked", "[core][plan]")
{
    const PassLibrary library = small_library();
    const Plan plan = planned(small_graph(library), kOptions);
    const auto json = nlohmann::json::parse(to_json(plan, false));
    CHECK(json["passgraph"] == 1);
    CHECK(json["extent"] == nlohmann::json({512, 256}));
    CHECK(json["imports"][0]["name"] == "photo");
    CHECK(json["imports"][0]["kind"] == "picture");
    REQUIRE(json["steps"].size() == 3);
    CHECK(json["steps"][2]["passes"] == nlohmann::json({"blur_2", "tone"}));
    CHECK(json["steps"][0]["reads"][0]["source"] == "import");
    CHECK(json["steps"][0]["depth_slot"].is_null());
    CHECK(json["steps"][0]["uniforms"][0]["place"] == "lift.amount");
    CHECK(json["steps"][0]["uniforms"][0]["value"] == nlohmann::json({0.5}));
    CHECK(json["steps"][0]["uniforms"][0]["range"][1].is_null()); // no upper bound
    CHECK(json["slots"][2]["format"] == "rgba8");
    CHECK(json["culled"][0]["pass"] == "lonely");
    CHECK(json["inlined"] == nlohmann::json({"blur_2"}));
    CHECK(json["outputs"][0]["codec"] == "rgba8");
    CHECK(!json["steps"][0].contains("fragment"));
    const auto with_glsl = nlohmann::json::parse(to_json(plan, true));
    CHECK(with_glsl["steps"][0]["fragment"] == plan.steps[0].fragment);
}

TEST_CASE("names in a digraph are quoted", "[core][plan]")
{
    Plan plan;
    plan.imports.push_back({Plan::Import::Kind::picture, "a \"b\" \\c", Signal::radiance, {1, 1}});
    CHECK_THAT(to_dot(plan), Contains(R"([label="a \"b\" \\c", shape=ellipse])"));
}
