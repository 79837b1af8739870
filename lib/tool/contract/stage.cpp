// Compiles one pass alone and rewrites its plan so that nothing stands between its values and binary32.
#include "tool/contract/stage.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "tool/contract/hostile.hpp"

namespace passgraph::tool::contract {
namespace {

constexpr const char* kNode = "pass_under_test";

/// A codec whose codes are the values themselves; what their format is does not show in the GLSL.
std::string plain_codec(Signal signal)
{
    std::string best;
    for (const Codec& codec : codecs_of(signal))
        if (codec.packing == Packing::plain && !is_depth(codec.format))
            best = codec.name;
    return best;
}

void wire_inputs(Graph& graph, const PassDeclaration& pass, const StageOptions& options, PassArguments& arguments)
{
    for (const InputPort& port : pass.inputs) {
        if (port.over == Over::scene) {
            arguments.inputs.push_back({port.name, graph.scene(port.name).elements});
            continue;
        }
        const Signal signal = signal_of(port.signal, options);
        arguments.inputs.push_back({port.name, port.over == Over::sphere ? graph.cube(port.name, signal)
                                                                         : graph.picture(port.name, signal)});
    }
}

Graph graph_of(const PassLibrary& library, const PassDeclaration& pass, const StageOptions& options)
{
    Graph graph(library);
    PassArguments arguments;
    arguments.name = kNode;
    arguments.settings = options.settings;
    wire_inputs(graph, pass, options, arguments);
    const bool is_geometry = pass.kind == PassKind::geometry;
    for (const OutputPort& port : pass.outputs) {
        const std::string codec = plain_codec(signal_of(port.signal, options));
        if (!codec.empty() && !options.takes_codecs_of_layout && !(is_geometry && port.signal == Signal::depth))
            arguments.codecs.push_back({port.name, {}, codec, {}});
    }
    const AddedPass added = graph.add(pass.name, std::move(arguments));
    for (const OutputPort& port : pass.outputs)
        graph.output(port.name, added[port.name]);
    return graph;
}

void store_in_binary32(Plan& plan)
{
    for (Plan::Slot& slot : plan.slots)
        if (!is_depth(slot.format))
            slot.format = Format::rgba32f;
    for (Plan::Output& output : plan.outputs)
        if (!is_depth(output.codec.format) && output.codec.packing == Packing::plain)
            output.codec = {"rgba32f", Format::rgba32f, Packing::plain};
}

/// A step that reads no image is a function of a place alone, which fewer places sample as well: a table of 64 x 64, each
/// texel an integral, would cost more than all else.
void sample_coarsely(Plan& plan)
{
    constexpr Extent kMost{17, 13};
    for (Plan::Step& step : plan.steps) {
        if (!step.reads.empty() || step.kind != Plan::Step::Kind::draw || step.extent.width * step.extent.height <= kMost.width * kMost.height)
            continue;
        step.extent = kMost;
        for (const Plan::Target& target : step.targets) {
            plan.slots[static_cast<size_t>(target.slot)].extent = kMost;
            for (Plan::Output& output : plan.outputs)
                if (output.source == Plan::Read::Source::slot && output.index == target.slot)
                    output.extent = kMost;
        }
    }
}

} // namespace

std::string to_text(const Settings& settings)
{
    std::string text;
    for (const PassArguments::Setting& setting : settings)
        text += fmt::format("{}{}={}", text.empty() ? "" : " ", setting.name,
                            setting.numbers.empty() ? setting.item : fmt::format("{}", fmt::join(setting.numbers, ",")));
    return text;
}

Signal signal_of(Signal declared, const StageOptions& options)
{
    return declared == Signal::color ? options.generic : declared;
}

Extent extent_of(const InputPort& port, const StageOptions& options)
{
    constexpr int kFace = 4; // a cube's faces are squares; a few texels have neighbours on all sides
    return port.over == Over::sphere ? Extent{kFace, kFace} : options.extent;
}

Result<Plan> plan_of(const PassLibrary& library, const PassPtr& pass, const StageOptions& options)
{
    CompileOptions compiling;
    compiling.extent = options.extent;
    for (const InputPort& port : pass->inputs)
        compiling.picture_extents[port.name] = extent_of(port, options);
    compiling.alias = false; // each image has an extent of its own
    compiling.specialise = options.takes_codecs_of_layout; // a pass that is left out shows nothing
    compiling.guards = options.is_guarded;
    compiling.import_guards = options.is_guarded;
    Result<Plan> plan = compile(graph_of(library, *pass, options), compiling);
    if (!plan)
        return plan;
    if (!options.takes_codecs_of_layout)
        store_in_binary32(*plan);
    sample_coarsely(*plan);
    if (!options.hostile.empty())
        for (Plan::Step& step : plan->steps) {
            step.fragment = with_hostile(step.fragment, options.hostile, options.forgiving);
            if (step.kind == Plan::Step::Kind::geometry)
                step.vertex = with_hostile(step.vertex, options.hostile, options.forgiving);
        }
    if (!options.removed_bound.empty())
        for (Plan::Step& step : plan->steps)
            step.fragment = with_bound_removed(step.fragment, options.removed_bound, options.kept_argument);
    return plan;
}

Result<Stage> Stage::create(const PassLibrary& library, const PassPtr& pass, const StageOptions& options, GlLoader loader)
{
    Result<Plan> plan = plan_of(library, pass, options);
    if (!plan)
        return tl::unexpected(std::move(plan.error()));
    RendererOptions device;
    device.loader = loader;
    device.scrubs_imports = false; // what is injected arrives at the shader
    Result<Renderer> renderer = Renderer::create(std::move(*plan), device);
    if (!renderer)
        return tl::unexpected(std::move(renderer.error()));
    return Stage(pass, std::move(*renderer));
}

Result<std::map<std::string, Picture>> Stage::run(const Feed& feed, const Scene* scene)
{
    if (scene != scene_ && scene != nullptr)
        if (Result<void> set = renderer_.set_scene(*scene); !set)
            return tl::unexpected(std::move(set.error()));
    scene_ = scene;
    for (const Plan::Import& import : plan().imports) {
        const auto picture = feed.find(import.name);
        if (picture == feed.end())
            continue;
        Result<void> done;
        if (import.kind == Plan::Import::Kind::cube) {
            std::array<Picture, 6> faces;
            faces.fill(picture->second);
            done = renderer_.import_cube(import.name, faces);
        } else {
            done = renderer_.import_picture(import.name, picture->second);
        }
        if (!done)
            return tl::unexpected(std::move(done.error()));
    }
    if (Result<void> drawn = renderer_.render(); !drawn)
        return tl::unexpected(std::move(drawn.error()));
    std::map<std::string, Picture> outputs;
    for (const Plan::Output& output : plan().outputs) {
        Result<Picture> values = renderer_.read(output.name);
        if (!values)
            return tl::unexpected(std::move(values.error()));
        outputs[output.name] = std::move(*values);
    }
    return outputs;
}

} // namespace passgraph::tool::contract
