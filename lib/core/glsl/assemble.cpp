// Complete GLSL programs from passes: accessors, parameters, bodies, and a main that evaluates each pass once.
#include "core/glsl/assemble.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/glsl/accessors.hpp"
#include "core/glsl/flat.hpp"
#include "core/glsl/inputs.hpp"
#include "passgraph/core/glsl_interface.hpp"

namespace passgraph::glsl {
namespace {

void add_settings(ProgramText& text, const Instance& instance, const Flats& flats, Renames& renames)
{
    const PassDeclaration& pass = *instance.pass;
    for (size_t i = 0; i < pass.params.size(); ++i) {
        const Param& param = pass.params[i];
        const std::string uniform = uniform_name(instance.number, param.name);
        const std::string name = instance.is_static[i] ? uniform : name_in(flats, uniform);
        renames.emplace_back(param.name, name);
        if (instance.is_static[i])
            text.add_line(fmt::format("const {} {} = {};", glsl_type_of(param.type), name,
                                      literal(param.type, instance.params[i])));
        else
            text.add(declared(flats, std::string(glsl_type_of(param.type)), uniform));
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

/// Of a geometry pass's direction nothing is kept but octahedral codes, which are of a direction of any length.
bool keeps_only_octahedral_codes(const StepSource& step, const Instance& instance, size_t output)
{
    if (step.kind != PassKind::geometry || info(instance.signals[output]).guard != Guard::unit_vector)
        return false;
    const std::string name = value_name(instance, output);
    for (const std::vector<StoredValue>& target : step.targets)
        for (const StoredValue& stored : target)
            if (stored.value == name && stored.codec.packing != Packing::octahedral)
                return false;
    return true;
}

std::string guarded_output(const StepSource& step, const Instance& instance, size_t output, const std::string& value)
{
    const bool carries_alpha =
        info(instance.signals[output]).has_alpha && instance.pass->outputs[output].signal == Signal::color;
    const std::string whole = carries_alpha ? fmt::format("vec4({}, {})", value, alpha_of(instance)) : value;
    if (!step.has_guards)
        return whole;
    return keeps_only_octahedral_codes(step, instance, output) ? fmt::format("passgraph_guard_direction({})", whole)
                                                               : glsl_guard_call(instance.signals[output], whole);
}

/// The pass does nothing at the part's pixels.
bool is_idle(const PassDeclaration& pass, Part part)
{
    return (part == Part::background && pass.only_where == OnlyWhere::depth) ||
           (part == Part::surfaces && pass.only_where == OnlyWhere::no_depth);
}

/// What a pass is at pixels where it does nothing: the input it names, guarded already if it is a value of the same step, or 0.
void add_idle_values(ProgramText& text, const StepSource& step, const Instance& instance)
{
    const PassDeclaration& pass = *instance.pass;
    for (size_t i = 0; i < pass.outputs.size(); ++i) {
        const std::string name = value_name(instance, i);
        if (pass.elsewhere.empty()) {
            text.add_line(fmt::format("    {} = {}(0.0);", name, glsl_type(info(instance.signals[i]).components)));
            continue;
        }
        const InputSource& source = instance.inputs[static_cast<size_t>(pass.find_input(pass.elsewhere))];
        const bool is_guarded = source.kind == InputSource::Kind::value && source.signal == instance.signals[i];
        const std::string value = fmt::format("{}{}(uv)", prefix_of(instance.number), pass.elsewhere);
        text.add_line(fmt::format("    {} = {};", name, is_guarded ? source.name : guarded_output(step, instance, i, value)));
    }
}

/// Every stored value is the 0 of a pass that does nothing in the background.
bool is_background_black(const StepSource& step)
{
    const auto is_zero = [&](const StoredValue& stored) {
        for (const Instance& instance : step.instances)
            for (size_t i = 0; i < instance.pass->outputs.size(); ++i)
                if (value_name(instance, i) == stored.value)
                    return is_idle(*instance.pass, Part::background) && instance.pass->elsewhere.empty() && stored.codec.packing == Packing::plain;
        return false;
    };
    return std::all_of(step.targets.begin(), step.targets.end(),
                       [&](const auto& target) { return std::all_of(target.begin(), target.end(), is_zero); });
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
    const PassDeclaration& pass = *instance.pass;
    if (is_idle(pass, part)) {
        add_idle_values(text, step, instance);
        return;
    }
    const std::string prefix = prefix_of(instance.number);
    if (kind == PassKind::image && pass.outputs.size() == 1) {
        text.add_line(fmt::format("    {} = {};", value_name(instance, 0),
                                  guarded_output(step, instance, 0, only_value(instance))));
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
                                  guarded_output(step, instance, i, fmt::format("{}raw_{}", prefix, pass.outputs[i].name))));
    }
}

void add_instance(ProgramText& text, const StepSource& step, const Instance& instance, const Flats& flats, Part part)
{
    Renames renames;
    for (size_t i = 0; i < instance.pass->outputs.size(); ++i)
        text.add_line(fmt::format("{} {};", glsl_type(info(instance.signals[i]).components), value_name(instance, i)));
    add_inputs(text, instance, flats, renames, part);
    add_settings(text, instance, flats, renames);
    const std::string prefix = prefix_of(instance.number);
    text.add_module(instance.pass->body, prefix, renames);
    if (!instance.pass->skip_when.empty() && instance.may_skip)
        text.add_module(skip_text(*instance.pass), prefix, std::move(renames));
    if (!instance.is_called)
        return;
    const auto [width, height] = instance.inputs.front().extent; // all are of one
    text.add_line(fmt::format(R"({} {}(vec2 texel)
{{
    passgraph_texel = ivec2(texel);
    vec2 uv = (texel + 0.5) * vec2({:#}, {:#});
    return {};
}})",
                              glsl_type(info(instance.signals.front()).components), called_name(instance), 1.0 / width, 1.0 / height,
                              guarded_output(step, instance, 0, only_value(instance))));
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

std::string sampler_text(const SamplerDeclaration& sampler, const Flats& flats)
{
    if (sampler.is_cube)
        return fmt::format("uniform samplerCube {};\n{}", sampler.name,
                           declared(flats, "vec3", harmonics_name(sampler.name), kHarmonics));
    if (!sampler.loaded_format.empty())
        return fmt::format("layout({}) readonly uniform image2D {};\n", sampler.loaded_format, sampler.name);
    return fmt::format("uniform sampler2D {};\n", sampler.name);
}

std::string fragment_text(const StepSource& step, const Flats& flats, std::vector<std::string>& sources, Part part)
{
    ProgramText text(sources);
    text.add_line("#version 330 core");
    if (std::any_of(step.samplers.begin(), step.samplers.end(), [](const auto& sampler) { return !sampler.loaded_format.empty(); }))
        text.add_line("#extension GL_ARB_shader_image_load_store : require");
    if (step.kind == PassKind::geometry)
        text.add_line("in vec3 passgraph_placed;\nin vec3 passgraph_facing;\nin vec2 passgraph_uv;");
    else
        text.add_line("noperspective in vec2 passgraph_uv;");
    for (size_t i = 0; i < step.targets.size(); ++i)
        text.add_line(fmt::format("layout(location = {}) out vec4 passgraph_target_{};", i, i));
    for (const SamplerDeclaration& sampler : step.samplers)
        text.add(sampler_text(sampler, flats));
    if (std::any_of(step.samplers.begin(), step.samplers.end(), [](const auto& sampler) { return sampler.is_cube; }))
        text.add(sphere_functions());
    text.add(glsl_codec_functions());
    text.add(accessors(step.reads, step.kind, step.facts, flats));
    text.add_line(fmt::format("ivec2 pixel() {{ return ivec2(gl_FragCoord.xy); }}\nivec2 pixel_count() {{ return ivec2({}, {}); }}",
                              step.extent.width, step.extent.height));
    if (std::any_of(step.instances.begin(), step.instances.end(), [](const auto& instance) { return instance.looks_at_texels; }))
        text.add_line("ivec2 passgraph_texel = ivec2(0);");
    for (const Instance& instance : step.instances)
        add_instance(text, step, instance, flats, part);
    text.add_line("void main()\n{\n    vec2 uv = passgraph_uv;");
    for (const Instance& instance : step.instances)
        if (!instance.is_called)
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
    add_settings(text, instance, {}, renames);
    text.add_module(instance.pass->body, prefix_of(instance.number), std::move(renames));
    text.add_line("void main()\n{");
    if (step.reads.elements)
        text.add_line("    passgraph_cell = passgraph_element[6];");
    text.add_line(fmt::format(
        "    p{}_{}_vertex(passgraph_vertex_position, passgraph_vertex_normal, passgraph_vertex_uv, passgraph_placed, "
        "passgraph_facing, passgraph_uv);",
        instance.number, instance.pass->name));
    text.add_line("    gl_Position = passgraph_clip_from_view * vec4(passgraph_placed, 1.0);\n}");
    return text.take();
}

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

std::string called_name(const Instance& instance) { return fmt::format("p{}_passgraph_value", instance.number); }

std::string uniform_name(int instance_number, std::string_view param)
{
    return fmt::format("p{}_{}", instance_number, param);
}

StepText assemble(const StepSource& step, const StepSource* scout)
{
    const Flats flats = flats_of(step);
    StepText text;
    text.vertex = step.kind == PassKind::geometry ? geometry_vertex_text(step, text.sources) : full_screen_vertex(flats);
    text.fragment = fragment_text(step, flats, text.sources, step.has_background ? Part::surfaces : Part::whole);
    if (step.has_background && !is_background_black(step))
        text.background = fragment_text(step, flats, text.sources, Part::background);
    if (step.has_skipped_variant)
        text.when_skipped = fragment_text(step, flats, text.sources, Part::when_skipped);
    if (scout != nullptr)
        text.scout = fragment_text(*scout, flats, text.sources, Part::whole);
    return text;
}

} // namespace passgraph::glsl
