// The GLSL of steps: what is called, what is fetched, how names are kept apart.
#include <algorithm>

#include <passgraph/core/glsl_interface.hpp>
#include <passgraph/core/graph_file.hpp>
#include <passgraph/core/pass_header.hpp>

#include "core_support.hpp"
#include "support/catch.hpp"

using namespace passgraph;
using namespace passgraph::test;
using Catch::Contains;

namespace {

PassPtr pointwise(const std::string& text)
{
    auto pass = read_pass_header(text, "passes/" + text.substr(text.find("\"pass\": \"") + 9, 4) + ".glsl", "test", [](std::string_view name) -> std::optional<IncludedFile> {
        return IncludedFile{"common/" + std::string(name), "float shared_half(float x) { return 0.5 * x; }\n"};
    });
    if (!pass)
        FAIL(to_text(pass.error()));
    for (InputPort& port : pass->inputs)
        port.access = {AccessClass::pointwise, 0};
    return std::make_shared<const PassDeclaration>(std::move(*pass));
}

PassLibrary glsl_library()
{
    PassLibrary library;
    library.add(pointwise(R"(/*{ "pass": "gain", "inputs": { "image": "color" }, "outputs": { "color": "color" },
  "params": { "amount": { "type": "float", "default": 0.5 }, "tint": { "type": "color", "default": [0.25, 0.5, 1], "static": true } },
  "choices": { "mode": ["plain", "fancy"] } }*/
#include "half.glsl"
const float bias = 0.25;
vec3 gain(vec2 uv) { return image(uv) * shared_half(amount) + bias; }
)"));
    library.add(pointwise(R"(/*{ "pass": "pair", "inputs": { "image": "radiance", "glow": { "signal": "radiance", "optional": true, "default": [1, 2, 3] } },
  "outputs": { "first": "radiance", "second": "radiance" } }*/
#define DOUBLE(x) (2.0 * (x))
void pair(vec2 uv, out vec3 first, out vec3 second) { first = DOUBLE(image(uv)); second = glow(uv); }
)"));
    return library;
}

size_t count(const std::string& text, const std::string& part)
{
    size_t found = 0;
    for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++found;
    return found;
}

std::string main_of(const std::string& fragment) { return fragment.substr(fragment.find("void main()")); }

PassArguments reading(AnyImage image)
{
    PassArguments arguments;
    arguments.inputs.push_back({"image", image});
    return arguments;
}

/// gain -> gain, fused.
Plan two_gains(const PassLibrary& library, Signal signal, const std::vector<std::pair<std::string, Location>>& statics = {})
{
    Graph graph(library);
    PassArguments first = reading(graph.picture("photo", signal));
    first.statics = statics;
    graph.output("color", graph.add("gain", reading(graph.add("gain", first)[""]))[""]);
    return planned(graph, {.extent = {64, 32}});
}

} // namespace

TEST_CASE("a fused step evaluates each pass once and fetches nothing between them", "[core][glsl]")
{
    const PassLibrary library = glsl_library();
    const Plan plan = two_gains(library, Signal::radiance);
    REQUIRE(plan.steps.size() == 1);
    const std::string& text = plan.steps.front().fragment;
    CHECK(main_of(text) == R"(void main()
{
    vec2 uv = passgraph_uv;
    v0_color = passgraph_guard_zero_to_cap(p0_gain(uv), 65504.0);
    v1_color = passgraph_guard_zero_to_cap(p1_gain(uv), 65504.0);
    passgraph_target_0 = vec4(v1_color, 1.0);
}
)");
    CHECK(count(text, "texture(t0, uv)") == 1); // the host's picture
    CHECK(count(text, "texture(") == 1);
    CHECK_THAT(text, Contains("vec3 p0_image(vec2 uv) { return passgraph_guard_zero_to_cap(texture(t0, uv).rgb, 65504.0); }"));
    CHECK_THAT(text, Contains("vec3 p1_image(vec2 uv) { return v0_color; }"));
    CHECK_THAT(text, Contains("vec2 p1_image_texel() { return vec2(0.015625, 0.03125); }\nivec2 p1_image_size() { return ivec2(64, 32); }"));
}

TEST_CASE("names of each use are kept apart, and lines keep their numbers", "[core][glsl]")
{
    const PassLibrary library = glsl_library();
    const Plan plan = two_gains(library, Signal::radiance);
    const std::string& text = plan.steps.front().fragment;
    for (const char* name : {"gain", "bias", "image", "image_texel", "image_size", "amount", "tint"}) {
        CHECK_THAT(text, Contains(std::string("p0_") + name) && Contains(std::string("p1_") + name));
        CHECK(count(text, std::string(" ") + name + "(") == 0);
    }
    CHECK(count(text, "#define mode 0\n#define mode_plain 0\n#define mode_fancy 1\n") == 2);
    CHECK(count(text, "float c0_shared_half(float x)") == 1); // an include is emitted once per step
    CHECK(count(text, "#line 3 ") == 2); // the line of the header's end
    const auto& sources = plan.steps.front().sources;
    const auto pass = std::find(sources.begin(), sources.end(), "passes/gain.glsl");
    const auto common = std::find(sources.begin(), sources.end(), "common/half.glsl");
    REQUIRE(pass != sources.end());
    REQUIRE(common != sources.end());
    CHECK_THAT(text, Contains("#line 3 " + std::to_string(pass - sources.begin()) + "\n"));
    CHECK_THAT(text, Contains("#line 1 " + std::to_string(common - sources.begin()) + "\n"));
}

TEST_CASE("live parameters are uniforms that come by the vertex stage, static ones constants", "[core][glsl]")
{
    const PassLibrary library = glsl_library();
    const Plan live = two_gains(library, Signal::radiance);
    CHECK_THAT(live.steps.front().fragment, Contains("flat in float flat_p0_amount;") && Contains("flat in float flat_p1_amount;") &&
                                                Contains("const vec3 p0_tint = vec3(0.25, 0.5, 1.0);"));
    REQUIRE(live.steps.front().uniforms.size() == 2);
    CHECK(live.steps.front().uniforms[1].name == "p1_amount");
    CHECK(live.steps.front().uniforms[1].place == "gain_2.amount");
    const Plan folded = two_gains(library, Signal::radiance, {{"amount", {}}});
    CHECK_THAT(folded.steps.front().fragment, Contains("const float p0_amount = 0.5;") && Contains("flat in float flat_p1_amount;"));
    CHECK(folded.steps.front().uniforms.size() == 1);
}

TEST_CASE("a pass for colors carries the alpha it does not see", "[core][glsl]")
{
    const PassLibrary library = glsl_library();
    const std::string text = two_gains(library, Signal::display_alpha).steps.front().fragment;
    CHECK_THAT(text, Contains("vec4 v0_color;"));
    CHECK_THAT(text, Contains("vec3 p0_image(vec2 uv) { return (passgraph_guard_zero_to_cap(texture(t0, uv), 1.0)).rgb; }"));
    CHECK_THAT(text, Contains("vec3 p1_image(vec2 uv) { return (v0_color).rgb; }\nfloat p1_image_alpha(vec2 uv) { return (v0_color).a; }"));
    CHECK_THAT(main_of(text), Contains("v0_color = passgraph_guard_zero_to_cap(vec4(p0_gain(uv), p0_image_alpha(uv)), 1.0);") &&
                                  Contains("passgraph_target_0 = v1_color;"));
}

TEST_CASE("several outputs are out parameters, each guarded; an input left open is its default", "[core][glsl]")
{
    const PassLibrary library = glsl_library();
    Graph graph(library);
    const AddedPass pair = graph.add("pair", reading(graph.picture<Radiance>("photo")));
    graph.output("one", pair["first"]);
    graph.output("two", pair["second"]);
    const Plan plan = planned(graph);
    const std::string& text = plan.steps.front().fragment;
    CHECK(main_of(text) == R"(void main()
{
    vec2 uv = passgraph_uv;
    vec3 p0_raw_first;
    vec3 p0_raw_second;
    p0_pair(uv, p0_raw_first, p0_raw_second);
    v0_first = passgraph_guard_zero_to_cap(p0_raw_first, 65504.0);
    v0_second = passgraph_guard_zero_to_cap(p0_raw_second, 65504.0);
    passgraph_target_0 = vec4(v0_first, 1.0);
    passgraph_target_1 = vec4(v0_second, 1.0);
}
)");
    CHECK_THAT(text, Contains("vec3 p0_glow(vec2 uv) { return vec3(1.0, 2.0, 3.0); }"));
    CHECK_THAT(text, Contains("#undef DOUBLE\n")); // macros of a pass end with it
    CHECK(plan.steps.front().reads.size() == 1);
}

TEST_CASE("an output that nobody reads is no target", "[core][glsl]")
{
    const PassLibrary library = glsl_library();
    Graph graph(library);
    graph.output("two", graph.add("pair", reading(graph.picture<Radiance>("photo")))["second"]);
    const Plan plan = planned(graph);
    REQUIRE(plan.steps.front().targets.size() == 1);
    CHECK(plan.steps.front().targets.front().image == "pair.second");
    CHECK_THAT(main_of(plan.steps.front().fragment), Contains("passgraph_target_0 = vec4(v0_second, 1.0);"));
}

TEST_CASE("a G-buffer's layout stores each output in its codec, and drops what nobody reads", "[core][glsl]")
{
    const auto g_buffer = [](const std::string& outputs, const std::string& codecs) {
        const auto description = read_graph_description(R"({ "passgraph": 1, "inputs": { "scene": { "kind": "scene" } }, "passes": {
  "surface": { "pass": "gbuffer", "inputs": { "scene": "scene" }, "choices": { "layout": "four_target" }, "codecs": {)" + codecs + R"(} } },
  "outputs": {)" + outputs + "} }", "g.json");
        REQUIRE(description);
        return planned(build_graph(*description, builtin_passes()));
    };
    const std::string all = R"("a": "surface.albedo", "m": "surface.material", "n": "surface.normal", "p": "surface.position", "d": "surface.depth", "e": "surface.emissive")";
    const Plan plan = g_buffer(all, "");
    REQUIRE(plan.steps.size() == 1);
    CHECK(plan.steps.front().kind == Plan::Step::Kind::geometry);
    const auto format_of = [](const Plan& from, const std::string& image) {
        for (const Plan::Slot& slot : from.slots)
            if (slot.images.front() == image)
                return std::string(name(slot.format));
        return std::string("not stored");
    };
    CHECK(format_of(plan, "surface.albedo") == "srgb8_a8");
    CHECK(format_of(plan, "surface.normal") == "rg16");
    CHECK(format_of(plan, "surface.position") == "rgba32f");
    CHECK(format_of(plan, "surface.depth") == "depth32f");
    CHECK(format_of(plan, "surface.emissive") == "r11f_g11f_b10f");
    CHECK(plan.steps.front().targets.size() == 5);
    CHECK(plan.steps.front().depth_slot >= 0);
    CHECK(plan.steps.front().host.elements);
    CHECK(plan.steps.front().host.camera);
    CHECK_THAT(plan.steps.front().fragment, Contains("vec4(passgraph_octahedral_encode(v0_normal, 65535.0), 0.0, 1.0)"));

    const Plan own = g_buffer(R"("n": "surface.normal")", R"("normal": "rgb10_a2")");
    CHECK(format_of(own, "surface.normal") == "rgb10_a2"); // the node's own choice goes before its layout's
    CHECK(format_of(own, "surface.depth") == "depth32f");  // geometry needs it
    CHECK(format_of(own, "surface.albedo") == "not stored");
    CHECK(own.steps.front().targets.size() == 1);
    CHECK_THAT(own.steps.front().fragment, Contains("passgraph_signed_10_encode(v0_normal)"));
}

TEST_CASE("guards, codecs and their GLSL calls name the signal's rule", "[core][glsl]")
{
    CHECK(glsl_guard_call(Signal::normal, "n") == "passgraph_guard_unit_vector(n)");
    CHECK(glsl_guard_call(Signal::display, "c") == "passgraph_guard_zero_to_cap(c, 1.0)");
    CHECK(glsl_guard_call(Signal::position, "p") == "passgraph_guard_finite(p, 3.4e+38)");
    CHECK(glsl_guard_call(Signal::exposure, "e") == "passgraph_guard_positive(e, 65504.0)");
    for (const SignalInfo& row : all_signals()) {
        for (const Codec& codec : codecs_of(row.signal)) {
            const std::string encoded = glsl_encode_call(row.signal, codec, "v");
            const std::string decoded = glsl_decode_call(row.signal, codec, "t");
            CHECK_THAT(row.components == 4 ? "vec4" : encoded, Contains("vec4"));
            for (const std::string& call : {encoded, decoded})
                if (const size_t start = call.find("passgraph_"); start != std::string::npos)
                    CHECK_THAT(std::string(glsl_codec_functions()) + glsl::accessors({.camera = true}, PassKind::image), Contains(" " + call.substr(start, call.find('(', start) - start) + "("));
        }
        const std::string guard = glsl_guard_call(row.signal, "v");
        CHECK_THAT(std::string(glsl_codec_functions()), Contains(std::string(glsl_type(row.components)) + " " + guard.substr(0, guard.find('(')) + "("));
    }
}
