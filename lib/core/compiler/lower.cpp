// Draws to steps: textures bound, targets attached, parameters as uniforms, and the GLSL of each step.
#include <algorithm>
#include <cassert>
#include <map>
#include <tuple>

#include <fmt/format.h>

#include "core/compiler/ir.hpp"
#include "core/glsl/assemble.hpp"

namespace passgraph::compiler {
namespace {

class StepLowering {
public:
    StepLowering(const Specialised& special, const Encoding& encoding, const Slots& slots,
                 const std::map<ImageRef, int, ImageLess>& imports, const Draw& draw, const Condition& condition,
                 const CompileOptions& options)
        : graph_(special.graph), black_inputs_(special.black_inputs), encoding_(encoding), slots_(slots), imports_(imports),
          draw_(draw), condition_(condition), options_(options)
    {
        if (options.specialise)
            source_.facts = options.facts;
        source_.has_guards = options.guards;
        source_.varying_components = options.device.max_varying_components;
    }

    Plan::Step run()
    {
        for (const int node : draw_.nodes)
            add_instance(node);
        add_targets();
        if (draw_.tested_depth) {
            step_.tested_depth_slot = slots_.slot_of.at(*draw_.tested_depth);
            source_.has_background = true;
        }
        add_condition();
        const std::optional<glsl::StepSource> scout = scout_source();
        glsl::StepText text = glsl::assemble(source_, scout ? &*scout : nullptr);
        step_.scout = std::move(text.scout);
        step_.scout_extent = scout ? scout->extent : Extent{};
        step_.background = std::move(text.background);
        step_.when_skipped = std::move(text.when_skipped);
        step_.vertex = std::move(text.vertex);
        step_.fragment = std::move(text.fragment);
        step_.sources = std::move(text.sources);
        step_.name = fmt::format("{}", fmt::join(step_.passes, " + "));
        step_.kind = source_.kind == PassKind::geometry ? Plan::Step::Kind::geometry : Plan::Step::Kind::draw;
        step_.host = source_.reads;
        return std::move(step_);
    }

private:
    static void add(Reads& into, const Reads& more)
    {
        for (const ReadRow& row : kReads)
            into.*row.member |= more.*row.member;
    }

    void add_instance(int node_index)
    {
        const GraphNode& node = graph_.node(node_index);
        glsl::Instance instance;
        instance.pass = node.pass.get();
        instance.number = static_cast<int>(source_.instances.size());
        instance.params = node.params;
        instance.is_static = node.is_static;
        instance.selections = node.selections;
        instance.is_called = draw_.called.contains(node_index);
        instance.looks_at_texels = instance.is_called;
        instance.may_skip = may_skip_at_all(options_); // drawing everything, the pass speaks for itself
        instance.is_black = options_.skipping == Skipping::always && options_.specialise && !node.pass->skip_when.empty();
        for (const TypedImage& image : graph_.images[static_cast<size_t>(node_index)])
            instance.signals.push_back(image.signal);
        for (size_t i = 0; i < node.inputs.size(); ++i)
            instance.inputs.push_back(input_source(node_index, i));
        for (size_t i = 0; i < node.pass->params.size(); ++i) {
            const Param& param = node.pass->params[i];
            if (!node.is_static[i])
                step_.uniforms.push_back({glsl::uniform_name(instance.number, param.name), node.place_of(i),
                                          param.type, node.params[i], param.lowest, param.highest});
        }
        source_.kind = node.pass->kind;
        add(source_.reads, node.pass->reads);
        source_.reads.camera |= source_.kind == PassKind::geometry; // places every vertex
        step_.passes.push_back(node.name);
        instance_of_[node_index] = instance.number;
        source_.instances.push_back(std::move(instance));
    }

    glsl::InputSource input_source(int node_index, size_t index)
    {
        const GraphNode& node = graph_.node(node_index);
        const InputPort& port = node.pass->inputs[index];
        const auto& wire = node.inputs[index];
        glsl::InputSource source;
        source.extent = {1, 1};
        if (const auto black = black_inputs_.find({node_index, static_cast<int>(index)}); black != black_inputs_.end()) {
            source.kind = glsl::InputSource::Kind::black;
            source.extent = black->second;
            return source;
        }
        if (!wire || port.over == Over::scene)
            return source;
        const TypedImage& image = graph_.image(wire->from);
        source.signal = image.signal;
        source.codec = encoding_.of(wire->from).codec;
        source.extent = image.extent;
        if (const auto inside = instance_of_.find(wire->from.node); inside != instance_of_.end()) {
            const glsl::Instance& producer = source_.instances[static_cast<size_t>(inside->second)];
            source.kind = producer.is_called ? glsl::InputSource::Kind::call : glsl::InputSource::Kind::value;
            source.name = producer.is_called ? glsl::called_name(producer) : glsl::value_name(producer, static_cast<size_t>(wire->from.output));
            source.filter = filter_of(*node.pass, port, node.selections);
            return source;
        }
        const bool looks_at_texels = draw_.called.contains(node_index) && !port.has_levels;
        return texture_source(wire->from, port, looks_at_texels ? Filter::nearest : filter_for(node, port, image), looks_at_texels);
    }

    /// `looks_at_texels`: at the centers of an image's texels only.
    glsl::InputSource texture_source(ImageRef from, const InputPort& port, Filter filter, bool looks_at_texels)
    {
        const TypedImage& image = graph_.image(from);
        glsl::InputSource source;
        source.signal = image.signal;
        source.codec = encoding_.of(from).codec;
        source.extent = image.extent;
        source.kind = port.over == Over::sphere ? glsl::InputSource::Kind::cube : glsl::InputSource::Kind::texture;
        // A scene's atlas holds albedo and material in codes of [0, 1]: nothing else can come from there.
        const bool is_coded = image.over == Over::table && info(image.signal).cap == 1.0f;
        source.is_import = options_.import_guards && imports_.contains(from) && !is_coded;
        source.is_black_when_skipped = condition_.black_inputs.contains(from);
        source.is_tested_depth = draw_.tested_depth && image.signal == Signal::depth &&
                                 encoding_.targets_of(from).contains(*draw_.tested_depth);
        source.is_loaded = looks_at_texels && may_load(from);
        for (const Layout::Place& place : encoding_.of(from).places)
            source.pieces.push_back({sampler_for(from, place.target, port, filter, source.is_loaded), place.channels});
        source_.reads.camera |= source.codec.packing == Packing::linear;
        return source;
    }

    /// At the centers of its own texels a linear filter gives the texel, at twice a nearest read's cost or more.
    Filter filter_for(const GraphNode& node, const InputPort& port, const TypedImage& image) const
    {
        const bool is_own_texel =
            port.over == Over::image && port.access.kind == AccessClass::pointwise &&
            image.extent == graph_.image(draw_.stored.front()).extent;
        if (port.over == Over::sphere)
            return Filter::linear;
        return is_own_texel ? Filter::nearest : filter_of(*node.pass, port, node.selections);
    }

    /// What the host supplies may be in a format that cannot be loaded.
    bool may_load(ImageRef image) const
    {
        if (imports_.contains(image))
            return false;
        std::set<int> loaded;
        for (const Plan::Read& read : step_.reads)
            if (read.is_loaded)
                loaded.insert(read.index);
        for (const TargetRef target : encoding_.targets_of(image)) {
            const Format format = encoding_.target(target).format;
            if (is_depth(format) || format == Format::srgb8_a8)
                return false;
            loaded.insert(slots_.slot_of.at(target));
        }
        return static_cast<int>(loaded.size()) <= options_.device.max_loaded_images;
    }

    /// The sampler that reads an image in the port's way; equal ways share one.
    std::string sampler_for(ImageRef image, int target, const InputPort& port, Filter filter, bool is_loaded)
    {
        Plan::Read read;
        const auto import = imports_.find(image);
        read.source = import == imports_.end() ? Plan::Read::Source::slot : Plan::Read::Source::import;
        read.index = import == imports_.end() ? slots_.slot_of.at({image.node, target}) : import->second;
        read.filter = filter;
        read.wrap = port.wrap;
        read.has_levels = port.has_levels || port.over == Over::sphere;
        read.is_loaded = is_loaded;
        read.image = import == imports_.end() ? target_name(graph_, encoding_, {image.node, target}) : graph_.name(image);
        const auto same = std::find_if(step_.reads.begin(), step_.reads.end(), [&](const Plan::Read& other) {
            return other.source == read.source && other.index == read.index && other.filter == read.filter &&
                   other.wrap == read.wrap && other.has_levels == read.has_levels && other.is_loaded == read.is_loaded;
        });
        if (same != step_.reads.end())
            return same->sampler;
        read.sampler = fmt::format("t{}", step_.reads.size());
        const std::string format(is_loaded ? name(encoding_.target({image.node, target}).format) : ""); // GLSL has the same names
        source_.samplers.push_back({read.sampler, port.over == Over::sphere, format});
        step_.reads.push_back(read);
        return read.sampler;
    }

    void add_targets()
    {
        for (const TargetRef target : targets_of(encoding_, draw_)) {
            const int slot = slots_.slot_of.at(target);
            step_.extent = graph_.images[static_cast<size_t>(target.node)].front().extent;
            source_.extent = step_.extent;
            if (is_depth(encoding_.target(target).format)) {
                step_.depth_slot = slot;
                continue;
            }
            source_.targets.push_back(stored_in(target));
            step_.targets.push_back(
                {slot, target_name(graph_, encoding_, target), glsl::black_codes(source_.targets.back())});
        }
    }

    void add_condition()
    {
        step_.counts = condition_.counts;
        step_.skipped_by = condition_.skipped_by;
        step_.is_cleared = condition_.is_cleared;
        source_.discards_black = condition_.counts >= 0;
        source_.has_skipped_variant = !condition_.black_inputs.empty();
        std::vector<std::string> names;
        for (const ImageRef image : condition_.black_inputs)
            names.push_back(graph_.name(image));
        step_.black_images = fmt::format("{}", fmt::join(names, " and "));
    }

    /// What looks first. It has the step's reads and parameters, and the samplers that it reads by.
    std::optional<glsl::StepSource> scout_source()
    {
        if (!condition_.scout)
            return std::nullopt;
        const Scout& scout = *condition_.scout;
        glsl::Instance instance;
        instance.pass = scout.pass.get();
        instance.number = static_cast<int>(source_.instances.size());
        instance.signals = {Signal::mask};
        instance.looks_at_texels = true;
        instance.may_skip = false;
        std::vector<ImageRef> images = scout.images;
        if (scout.node >= 0) {
            const GraphNode& asked = graph_.node(scout.node);
            instance.number = instance_of_.at(scout.node); // the same uniforms
            instance.params = asked.params;
            instance.is_static = asked.is_static;
            instance.selections = asked.selections;
            for (const auto& wire : asked.inputs)
                images.push_back(wire->from);
        }
        const size_t own_samplers = source_.samplers.size();
        for (size_t i = 0; i < images.size(); ++i)
            instance.inputs.push_back(texture_source(images[i], scout.pass->inputs[i], Filter::nearest, true));
        glsl::StepSource source;
        for (const glsl::SamplerDeclaration& sampler : source_.samplers)
            for (const glsl::InputSource& input : instance.inputs)
                if (std::any_of(input.pieces.begin(), input.pieces.end(), [&](const auto& piece) { return piece.sampler == sampler.name; })) {
                    source.samplers.push_back(sampler);
                    break;
                }
        source_.samplers.resize(own_samplers);
        const std::string value = glsl::value_name(instance, 0);
        source.instances.push_back(std::move(instance));
        source.targets = {{{value, Signal::mask, *find_codec(Signal::mask, "r8"), "r"}}};
        source.reads = scout.pass->reads;
        source.extent = scout.extent;
        source.discards_black = true;
        source.facts = source_.facts;
        return source;
    }

    /// Every image with a place in the target: which of its codes stand in which channels.
    std::vector<glsl::StoredValue> stored_in(TargetRef target)
    {
        const glsl::Instance& instance = source_.instances[static_cast<size_t>(instance_of_.at(target.node))];
        std::vector<glsl::StoredValue> values;
        const auto& storage = encoding_.storage[static_cast<size_t>(target.node)];
        for (int output = 0; output < static_cast<int>(storage.size()); ++output) {
            size_t code = 0;
            for (const Layout::Place& place : storage[static_cast<size_t>(output)].places) {
                if (place.target == target.target) {
                    const Codec& codec = storage[static_cast<size_t>(output)].codec;
                    values.push_back({glsl::value_name(instance, static_cast<size_t>(output)),
                                      graph_.image({target.node, output}).signal, codec, place.channels, code});
                    source_.reads.camera |= codec.packing == Packing::linear;
                }
                code += place.channels.size();
            }
        }
        return values;
    }

    const TypedGraph& graph_;
    const std::map<std::pair<int, int>, Extent>& black_inputs_;
    const Encoding& encoding_;
    const Slots& slots_;
    const std::map<ImageRef, int, ImageLess>& imports_;
    const Draw& draw_;
    const Condition& condition_;
    const CompileOptions& options_;
    Plan::Step step_;
    glsl::StepSource source_;
    std::map<int, int> instance_of_;
};

/// Host pictures and cube maps that a step reads or an output names.
std::map<ImageRef, int, ImageLess> find_imports(const TypedGraph& graph, const Draws& draws, Plan& plan)
{
    std::map<ImageRef, int, ImageLess> imports;
    const auto add = [&](ImageRef image) {
        const GraphNode& node = graph.node(image.node);
        if (node.kind == GraphNode::Kind::pass || !imports.emplace(image, static_cast<int>(plan.imports.size())).second)
            return;
        Plan::Import import;
        import.kind = graph.image(image).over == Over::table ? Plan::Import::Kind::atlas
                      : node.kind == GraphNode::Kind::scene  ? Plan::Import::Kind::sky
                      : node.kind == GraphNode::Kind::cube   ? Plan::Import::Kind::cube
                                                             : Plan::Import::Kind::picture;
        import.name = graph.name(image);
        import.signal = graph.image(image).signal;
        import.extent = graph.image(image).extent;
        plan.imports.push_back(import);
    };
    for (const Draw& draw : draws.draws)
        for (const ExternalRead& read : external_reads(graph, draw.nodes))
            add(read.image);
    for (const GraphOutput& output : graph.outputs)
        add(output.from);
    return imports;
}

} // namespace

Plan lower(const Specialised& special, const Encoding& encoding, const Draws& draws, const Order& order,
           const Conditions& conditions, const Slots& slots, const CompileOptions& options)
{
    const TypedGraph& graph = special.graph;
    Plan plan;
    plan.extent = options.extent;
    const auto imports = find_imports(graph, draws, plan);
    plan.slots = slots.slots;
    plan.bytes = slots.bytes;
    plan.bytes_unshared = slots.bytes_unshared;
    plan.boundaries = draws.boundaries;
    plan.inlined = draws.inlined;
    plan.queries.resize(conditions.counted.size());
    for (const int draw : order) {
        const Condition& condition = conditions.of_draw[static_cast<size_t>(draw)];
        plan.steps.push_back(
            StepLowering(special, encoding, slots, imports, draws.draws[static_cast<size_t>(draw)], condition, options).run());
        if (condition.counts >= 0)
            plan.queries[static_cast<size_t>(condition.counts)] = {
                static_cast<int>(plan.steps.size()) - 1, conditions.counted[static_cast<size_t>(condition.counts)]};
    }
    for (const GraphOutput& output : graph.outputs) {
        Plan::Output result;
        result.name = output.name;
        result.image = graph.name(output.from);
        const auto import = imports.find(output.from);
        result.source = import == imports.end() ? Plan::Read::Source::slot : Plan::Read::Source::import;
        const int target = encoding.of(output.from).places.front().target;
        result.index = import == imports.end() ? slots.slot_of.at({output.from.node, target}) : import->second;
        result.signal = graph.image(output.from).signal;
        result.codec = encoding.of(output.from).codec;
        result.extent = graph.image(output.from).extent;
        plan.outputs.push_back(std::move(result));
    }
    return plan;
}

} // namespace passgraph::compiler
