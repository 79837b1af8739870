// Complete GLSL programs from passes: accessors, parameters, bodies, and a main that evaluates each pass once.
#include "core/glsl/assemble.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/glsl/module_text.hpp"
#include "passgraph/core/glsl_interface.hpp"

namespace passgraph::glsl {
namespace {

using Renames = std::vector<std::pair<std::string, std::string>>;

/// The pixels, or the case, that a fragment stage is for.
enum class Part { whole, surfaces, background, when_skipped };

std::string prefix_of(int number) { return fmt::format("p{}_", number); }

/// The expression that reads an input at `place` ("uv, 0.0"), decoded, guarded when the host supplies it.
/// Codes that stand in the first channels of one texture are its texel; others are gathered into a vec4.
std::string texture_value(const InputSource& source, std::string_view function, std::string_view place)
{
    const auto fetch = [&](const InputSource::Piece& piece) {
        return fmt::format("{}({}, {})", function, piece.sampler, place);
    };
    std::string texel;
    size_t channels = 0;
    for (const InputSource::Piece& piece : source.pieces) {
        texel += fmt::format("{}.{}, ", fetch(piece), piece.channels);
        channels += piece.channels.size();
    }
    if (source.pieces.size() == 1 && std::string_view("rgba").starts_with(source.pieces.front().channels))
        texel = fetch(source.pieces.front());
    else
        texel = channels == 4 ? fmt::format("vec4({})", texel.substr(0, texel.size() - 2))
                              : fmt::format("vec4({}{}1.0)", texel, channels == 1 ? "0.0, 0.0, " : channels == 2 ? "0.0, " : "");
    std::string value = glsl_decode_call(source.signal, source.codec, texel);
    if (source.is_import)
        value = glsl_guard_call(source.signal, value);
    return value;
}

void add_image_accessor(ProgramText& text, const InputPort& port, const InputSource& source, const std::string& name,
                        Part part)
{
    const std::string_view type = glsl_type(seen_components(port));
    const bool drops_alpha = info(source.signal).has_alpha && seen_components(port) == 3;
    const auto add = [&](const std::string& suffix, const std::string& parameters, std::string_view function,
                         std::string_view place) {
        const bool is_zero = source.kind == InputSource::Kind::black || (part == Part::background && source.is_tested_depth) ||
                             (part == Part::when_skipped && source.is_black_when_skipped);
        const bool is_constant = source.kind == InputSource::Kind::constant || source.kind == InputSource::Kind::black;
        const int components = is_constant ? seen_components(port) : info(source.signal).components;
        const std::string whole = is_zero ? fmt::format("{}(0.0)", glsl_type(components))
                                  : source.kind == InputSource::Kind::value   ? source.name
                                  : source.kind == InputSource::Kind::texture ? texture_value(source, function, place)
                                                                              : constant_value(port);
        const bool is_wide = !is_constant && drops_alpha;
        text.add_line(fmt::format("{} {}{}({}) {{ return {}{}; }}", type, name, suffix, parameters,
                                  is_wide ? "(" + whole + ")" : whole, is_wide ? ".rgb" : ""));
        if (is_wide && suffix.empty())
            text.add_line(fmt::format("float {}_alpha(vec2 uv) {{ return ({}).a; }}", name, whole));
    };
    if (port.has_levels) {
        add("", "vec2 uv", "textureLod", "uv, 0.0");
        add("_lod", "vec2 uv, float lod", "textureLod", "uv, lod");
    } else {
        add("", "vec2 uv", "texture", "uv");
    }
    const bool has_own_extent = source.extent.width > 0; // a table's may be known only when it is bound
    if (!has_own_extent) {
        const std::string size = fmt::format("textureSize({}, 0)", source.pieces.front().sampler);
        text.add_line(fmt::format("vec2 {}_texel() {{ return 1.0 / vec2({}); }}", name, size));
        text.add_line(fmt::format("ivec2 {}_size() {{ return {}; }}", name, size));
        return;
    }
    text.add_line(fmt::format("vec2 {}_texel() {{ return vec2({:#}, {:#}); }}", name,
                              1.0 / std::max(source.extent.width, 1), 1.0 / std::max(source.extent.height, 1)));
    text.add_line(
        fmt::format("ivec2 {}_size() {{ return ivec2({}, {}); }}", name, source.extent.width, source.extent.height));
}

void add_sphere_accessor(ProgramText& text, const InputPort& port, const InputSource& source, const std::string& name)
{
    const std::string_view type = glsl_type(seen_components(port));
    const bool is_wired = source.kind == InputSource::Kind::cube;
    const std::string constant =
        source.kind == InputSource::Kind::black ? fmt::format("{}(0.0)", type) : constant_value(port);
    const std::string value = is_wired ? texture_value(source, "textureLod", "direction, lod") : constant;
    text.add_line(fmt::format("{} {}(vec3 direction, float lod) {{ return {}; }}", type, name, value));
    text.add_line(fmt::format("float {}_top_lod() {{ return {}; }}", name,
                              is_wired ? fmt::format("passgraph_top_level(textureSize({}, 0).x)", source.pieces.front().sampler) : "0.0"));
    if (!port.has_levels)
        return;
    const std::string irradiance = is_wired
                                       ? fmt::format("passgraph_irradiance({}, direction)", harmonics_name(source.pieces.front().sampler))
                                       : fmt::format("{} * 3.14159265358979324", constant);
    text.add_line(fmt::format("{} {}_irradiance(vec3 direction) {{ return {}; }}", type, name, irradiance));
}

void add_inputs(ProgramText& text, const Instance& instance, Renames& renames, Part part)
{
    const std::string prefix = prefix_of(instance.number);
    for (size_t i = 0; i < instance.pass->inputs.size(); ++i) {
        const InputPort& port = instance.pass->inputs[i];
        if (port.over == Over::scene)
            continue;
        const auto rename = [&](const std::string& suffix) {
            renames.emplace_back(port.name + suffix, prefix + port.name + suffix);
        };
        rename("");
        if (port.over == Over::sphere) {
            rename("_top_lod");
            if (port.has_levels)
                rename("_irradiance");
            add_sphere_accessor(text, port, instance.inputs[i], prefix + port.name);
        } else {
            rename("_texel");
            rename("_size");
            if (port.has_levels)
                rename("_lod");
            add_image_accessor(text, port, instance.inputs[i], prefix + port.name, part);
        }
    }
}

void add_settings(ProgramText& text, const Instance& instance, Renames& renames)
{
    const PassDeclaration& pass = *instance.pass;
    for (size_t i = 0; i < pass.params.size(); ++i) {
        const Param& param = pass.params[i];
        const std::string name = uniform_name(instance.number, param.name);
        renames.emplace_back(param.name, name);
        if (instance.is_static[i])
            text.add_line(fmt::format("const {} {} = {};", glsl_type_of(param.type), name,
                                      literal(param.type, instance.params[i])));
        else
            text.add_line(fmt::format("uniform {} {};", glsl_type_of(param.type), name));
        for (size_t item = 0; item < param.items.size(); ++item)
            renames.emplace_back(param.name + "_" + param.items[item], std::to_string(item));
    }
    for (size_t i = 0; i < pass.selections.size(); ++i) {
        const Selection& selection = pass.selections[i];
        renames.emplace_back(selection.name, std::to_string(instance.selections[i]));
        for (size_t item = 0; item < selection.items.size(); ++item)
            renames.emplace_back(selection.name + "_" + selection.items[item], std::to_string(item));
    }
}

/// The first generic input of a pass, from which alpha is carried; "" when there is none with alpha.
std::string alpha_of(const Instance& instance)
{
    for (size_t i = 0; i < instance.pass->inputs.size(); ++i)
        if (instance.pass->inputs[i].signal == Signal::color && info(instance.inputs[i].signal).has_alpha)
            return fmt::format("{}{}_alpha(uv)", prefix_of(instance.number), instance.pass->inputs[i].name);
    return "1.0";
}

std::string guarded_output(const Instance& instance, size_t output, const std::string& value, bool has_guards)
{
    const bool carries_alpha =
        info(instance.signals[output]).has_alpha && instance.pass->outputs[output].signal == Signal::color;
    const std::string whole = carries_alpha ? fmt::format("vec4({}, {})", value, alpha_of(instance)) : value;
    return has_guards ? glsl_guard_call(instance.signals[output], whole) : whole;
}

/// The pass does nothing at the part's pixels.
bool is_idle(const PassDeclaration& pass, Part part)
{
    return (part == Part::background && pass.only_where == OnlyWhere::depth) ||
           (part == Part::surfaces && pass.only_where == OnlyWhere::no_depth);
}

/// What a pass is at pixels where it does nothing: the input it names, or 0.
void add_idle_values(ProgramText& text, const Instance& instance, bool has_guards)
{
    const PassDeclaration& pass = *instance.pass;
    for (size_t i = 0; i < pass.outputs.size(); ++i) {
        const std::string value = pass.elsewhere.empty()
                                      ? fmt::format("{}(0.0)", glsl_type(info(instance.signals[i]).components))
                                      : fmt::format("{}{}(uv)", prefix_of(instance.number), pass.elsewhere);
        text.add_line(fmt::format("    {} = {};", value_name(instance, i),
                                  pass.elsewhere.empty() ? value : guarded_output(instance, i, value, has_guards)));
    }
}

/// The value of a pass of one output: 0 where its "skip" says so, else what its function returns.
std::string only_value(const Instance& instance)
{
    const PassDeclaration& pass = *instance.pass;
    const std::string prefix = prefix_of(instance.number);
    const std::string call = fmt::format("{}{}(uv)", prefix, pass.name);
    const std::string zero = fmt::format("{}(0.0)", glsl_type(info(pass.outputs.front().signal).components));
    if (instance.is_black)
        return zero;
    return pass.skip_when.empty() || !instance.may_skip ? call : fmt::format("({}{}(uv) ? {} : {})", prefix, kSkips, zero, call);
}

/// Evaluates one pass into its file-scope values.
void add_evaluation(ProgramText& text, const Instance& instance, const StepSource& step, Part part)
{
    const PassKind kind = step.kind;
    const bool has_guards = step.has_guards;
    const PassDeclaration& pass = *instance.pass;
    if (is_idle(pass, part)) {
        add_idle_values(text, instance, has_guards);
        return;
    }
    const std::string prefix = prefix_of(instance.number);
    if (kind == PassKind::image && pass.outputs.size() == 1) {
        text.add_line(fmt::format("    {} = {};", value_name(instance, 0),
                                  guarded_output(instance, 0, only_value(instance), has_guards)));
        return;
    }
    std::string call =
        kind == PassKind::image
            ? fmt::format("{}{}(uv", prefix, pass.name)
            : fmt::format("{}{}_surface(passgraph_placed, passgraph_facing, passgraph_uv", prefix, pass.name);
    for (const OutputPort& output : pass.outputs) {
        if (kind == PassKind::geometry && output.signal == Signal::depth)
            continue;
        text.add_line(fmt::format("    {} {}raw_{};", glsl_type(info(output.signal).components), prefix, output.name));
        call += fmt::format(", {}raw_{}", prefix, output.name);
    }
    text.add_line("    " + call + ");");
    for (size_t i = 0; i < pass.outputs.size(); ++i) {
        if (kind == PassKind::geometry && pass.outputs[i].signal == Signal::depth) {
            text.add_line(fmt::format("    {} = gl_FragCoord.z;", value_name(instance, i)));
            continue;
        }
        text.add_line(fmt::format("    {} = {};", value_name(instance, i),
                                  guarded_output(instance, i, fmt::format("{}raw_{}", prefix, pass.outputs[i].name), has_guards)));
    }
}

void add_instance(ProgramText& text, const Instance& instance, Part part)
{
    Renames renames;
    for (size_t i = 0; i < instance.pass->outputs.size(); ++i)
        text.add_line(fmt::format("{} {};", glsl_type(info(instance.signals[i]).components), value_name(instance, i)));
    add_inputs(text, instance, renames, part);
    add_settings(text, instance, renames);
    const std::string prefix = prefix_of(instance.number);
    text.add_module(instance.pass->body, prefix, renames);
    if (!instance.pass->skip_when.empty() && instance.may_skip)
        text.add_module(skip_text(*instance.pass), prefix, std::move(renames));
}

/// Leaves a pixel out if all that it would store is 0.
void add_black_discard(ProgramText& text, const StepSource& step)
{
    std::string all;
    for (const std::vector<StoredValue>& target : step.targets)
        for (const StoredValue& stored : target)
            all += fmt::format("{}{} == {}(0.0)", all.empty() ? "" : " && ", stored.value, glsl_type(info(stored.signal).components));
    text.add_line(fmt::format("    if ({})\n        discard;", all));
}

/// Codes of one value fill a target; those of several share it.
void add_target(ProgramText& text, const std::vector<StoredValue>& values, size_t location)
{
    const std::string target = fmt::format("passgraph_target_{}", location);
    const auto codes = [](const StoredValue& stored) { return glsl_encode_call(stored.signal, stored.codec, stored.value); };
    if (values.size() == 1 && values.front().first_code == 0 && std::string_view("rgba").starts_with(values.front().channels)) {
        text.add_line(fmt::format("    {} = {};", target, codes(values.front())));
        return;
    }
    text.add_line(fmt::format("    {} = vec4(0.0, 0.0, 0.0, 1.0);", target));
    for (const StoredValue& stored : values)
        text.add_line(fmt::format("    {}.{} = ({}).{};", target, stored.channels, codes(stored),
                                  std::string_view("rgba").substr(stored.first_code, stored.channels.size())));
}

std::string fragment_text(const StepSource& step, std::vector<std::string>& sources, Part part)
{
    ProgramText text(sources);
    text.add_line("#version 330 core");
    if (step.kind == PassKind::geometry)
        text.add_line("in vec3 passgraph_placed;\nin vec3 passgraph_facing;");
    text.add_line("in vec2 passgraph_uv;");
    for (size_t i = 0; i < step.targets.size(); ++i)
        text.add_line(fmt::format("layout(location = {}) out vec4 passgraph_target_{};", i, i));
    for (const SamplerDeclaration& sampler : step.samplers)
        text.add_line(sampler.is_cube ? fmt::format("uniform samplerCube {};\nuniform vec3 {}[{}];", sampler.name,
                                                    harmonics_name(sampler.name), kHarmonics)
                                      : fmt::format("uniform sampler2D {};", sampler.name));
    if (std::any_of(step.samplers.begin(), step.samplers.end(), [](const auto& sampler) { return sampler.is_cube; }))
        text.add(sphere_functions());
    text.add(glsl_codec_functions());
    text.add(accessors(step.reads, step.kind, step.facts));
    text.add_line(fmt::format("ivec2 pixel() {{ return ivec2(gl_FragCoord.xy); }}\nivec2 pixel_count() {{ return ivec2({}, {}); }}",
                              step.extent.width, step.extent.height));
    for (const Instance& instance : step.instances)
        add_instance(text, instance, part);
    text.add_line("void main()\n{\n    vec2 uv = passgraph_uv;");
    for (const Instance& instance : step.instances)
        add_evaluation(text, instance, step, part);
    if (step.discards_black)
        add_black_discard(text, step);
    for (size_t i = 0; i < step.targets.size(); ++i)
        add_target(text, step.targets[i], i);
    text.add_line("}");
    return text.take();
}

std::string geometry_vertex_text(const StepSource& step, std::vector<std::string>& sources)
{
    const Instance& instance = step.instances.front();
    ProgramText text(sources);
    text.add_line("#version 330 core");
    text.add_line(fmt::format("layout(location = {}) in vec3 passgraph_vertex_position;", kPositionLocation));
    text.add_line(fmt::format("layout(location = {}) in vec3 passgraph_vertex_normal;", kNormalLocation));
    text.add_line(fmt::format("layout(location = {}) in vec2 passgraph_vertex_uv;", kUvLocation));
    text.add_line("out vec3 passgraph_placed;\nout vec3 passgraph_facing;\nout vec2 passgraph_uv;");
    text.add(vertex_accessors(step.reads));
    Renames renames;
    add_settings(text, instance, renames);
    text.add_module(instance.pass->body, prefix_of(instance.number), std::move(renames));
    text.add_line("void main()\n{");
    text.add_line(fmt::format(
        "    p{}_{}_vertex(passgraph_vertex_position, passgraph_vertex_normal, passgraph_vertex_uv, passgraph_placed, "
        "passgraph_facing, passgraph_uv);",
        instance.number, instance.pass->name));
    text.add_line("    gl_Position = passgraph_clip_from_view * vec4(passgraph_placed, 1.0);\n}");
    return text.take();
}

constexpr const char* kFullScreenVertex = R"(#version 330 core
out vec2 passgraph_uv;
void main()
{
    // One triangle that covers the target; uv is exact at texel centers of extents up to 2^23.
    passgraph_uv = vec2(float((gl_VertexID << 1) & 2), float(gl_VertexID & 2));
    gl_Position = vec4(passgraph_uv * 2.0 - 1.0, 0.0, 1.0);
}
)";

} // namespace

int seen_components(const InputPort& port) { return info(port.signal).components; }

std::string constant_value(const InputPort& port)
{
    const int components = seen_components(port);
    const ParamType types[] = {ParamType::float_, ParamType::vec2, ParamType::vec3, ParamType::vec4};
    return literal(types[components - 1], port.default_value);
}

std::string value_name(const Instance& instance, size_t output)
{
    return fmt::format("v{}_{}", instance.number, instance.pass->outputs[output].name);
}

std::string uniform_name(int instance_number, std::string_view param)
{
    return fmt::format("p{}_{}", instance_number, param);
}

StepText assemble(const StepSource& step)
{
    StepText text;
    text.vertex = step.kind == PassKind::geometry ? geometry_vertex_text(step, text.sources) : kFullScreenVertex;
    text.fragment = fragment_text(step, text.sources, step.has_background ? Part::surfaces : Part::whole);
    if (step.has_background)
        text.background = fragment_text(step, text.sources, Part::background);
    if (step.has_skipped_variant)
        text.when_skipped = fragment_text(step, text.sources, Part::when_skipped);
    return text;
}

} // namespace passgraph::glsl
