// Values that are the same for a whole picture come by the vertex stage, as many as a device has room for.
#include <passgraph/core/graph_file.hpp>

#include "core_support.hpp"
#include "support/catch.hpp"

using namespace passgraph;
using namespace passgraph::test;
using Catch::Contains;

namespace {

/// The lit step of a scene with two lamps, one of them directional.
Plan::Step lit_step(int varying_components)
{
    const auto description = read_graph_description(R"({ "passgraph": 1, "inputs": { "scene": { "kind": "scene" } }, "passes": {
      "surface": { "pass": "gbuffer", "inputs": { "scene": "scene" } },
      "lit": { "pass": "pbr", "inputs": { "albedo": "surface.albedo", "material": "surface.material", "normal": "surface.normal",
               "position": "surface.position", "emissive": "surface.emissive", "sky": "scene.sky" } },
      "bright": { "pass": "bright", "inputs": { "image": "lit" } } },
      "outputs": { "color": "bright" } })", "g.graph.json");
    REQUIRE(description);
    CompileOptions options;
    options.device.max_varying_components = varying_components;
    options.facts.directional_lights = 1;
    options.facts.point_lights = 1;
    options.facts.spot_lights = 0;
    const auto plan = compile(build_graph(*description, builtin_passes()), options);
    REQUIRE(plan);
    for (const Plan::Step& step : plan->steps)
        if (step.fragment.find("pbr_surface") != std::string::npos)
            return step;
    FAIL("no step is lit");
    return {};
}

bool is_flat(const Plan::Step& step, const std::string& type, const std::string& name, const std::string& array = "")
{
    const bool is_declared = step.fragment.find("flat in " + type + " flat_" + name + array + ";\n") != std::string::npos;
    const bool is_handed_over = step.vertex.find("    flat_" + name + " = " + name + ";\n") != std::string::npos &&
                                step.vertex.find("uniform " + type + " " + name + array + ";\n") != std::string::npos;
    const bool is_uniform = step.fragment.find("uniform " + type + " " + name + array + ";\n") != std::string::npos;
    CHECK(is_declared == is_handed_over);
    CHECK(is_declared != is_uniform);
    return is_declared;
}

} // namespace

TEST_CASE("camera, lamps, parameters and the sky's harmonics are flat where there is room", "[core][glsl][flat]")
{
    const Plan::Step step = lit_step(120);
    CHECK_THAT(step.fragment, Contains("flat in vec4 passgraph_ray;\n") && !Contains("passgraph_camera_block"));
    CHECK_THAT(step.vertex, Contains("} passgraph_camera;\n") && Contains("    passgraph_ray = passgraph_camera.passgraph_ray;\n"));
    CHECK(is_flat(step, "vec4", "passgraph_light_rows", "[6]"));
    CHECK(is_flat(step, "float", "p3_threshold"));
    CHECK(is_flat(step, "vec3", "t5_harmonics", "[9]"));
}

TEST_CASE("what finds no room among a device's varyings stays a uniform", "[core][glsl][flat]")
{
    // 4 for uv, 40 for the camera, 24 for two lamps, 3 for the parameters, 27 for the harmonics.
    for (const auto& [components, camera, lamps, harmonics] :
         {std::tuple{98, true, true, true}, {97, true, true, false}, {68, true, true, false}, {67, true, false, false}, {43, false, true, false}}) {
        CAPTURE(components);
        const Plan::Step step = lit_step(components);
        CHECK((step.fragment.find("flat in vec4 passgraph_ray;") != std::string::npos) == camera);
        CHECK(is_flat(step, "vec4", "passgraph_light_rows", "[6]") == lamps);
        CHECK(is_flat(step, "vec3", "t5_harmonics", "[9]") == harmonics);
    }
}

TEST_CASE("a geometry step has no flat values but its element's cell of the atlas", "[core][glsl][flat]")
{
    const auto description = read_graph_description(R"({ "passgraph": 1, "inputs": { "scene": { "kind": "scene" } }, "passes": {
      "surface": { "pass": "gbuffer", "inputs": { "scene": "scene" } } }, "outputs": { "color": "surface.albedo" } })", "g.graph.json");
    REQUIRE(description);
    const auto plan = compile(build_graph(*description, builtin_passes()), {});
    REQUIRE(plan);
    CHECK_THAT(plan->steps.front().vertex, Contains("flat out vec4 passgraph_cell;") && Contains("    passgraph_cell = passgraph_element[6];"));
    CHECK_THAT(plan->steps.front().fragment, Contains("flat in vec4 passgraph_cell;") && !Contains("flat in vec4 passgraph_ray;"));
}
