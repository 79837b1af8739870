// Every mistake of a graph at once, each naming both ends and the fix; the result is a fully typed graph.
#include <algorithm>

#include <fmt/format.h>

#include "core/compiler/ir.hpp"

namespace passgraph::compiler {
namespace {

std::string_view over_text(Over over)
{
    switch (over) {
    case Over::image:
        return "an image";
    case Over::sphere:
        return "a cube map";
    case Over::table:
        return "a table";
    case Over::scene:
        return "a scene";
    }
    return "";
}

class Validator {
public:
    Validator(const Graph& graph, const CompileOptions& options)
        : graph_(graph), options_(options), errors_(graph.errors())
    {
        typed_.nodes = graph.nodes();
        typed_.outputs = graph.outputs();
        typed_.library = &graph.library();
    }

    Result<TypedGraph> run()
    {
        for (const GraphNode& node : graph_.nodes()) {
            current_ = &node;
            typed_.images.push_back(node.kind == GraphNode::Kind::pass ? type_pass() : type_source());
        }
        if (graph_.outputs().empty()) {
            const std::string file = graph_.nodes().empty() ? "" : graph_.nodes().front().where.file;
            report("output_missing", "the graph has no output", "name an image in \"outputs\"", {file});
        }
        for (const GraphOutput& output : graph_.outputs())
            check_output(output);
        if (!errors_.empty())
            return tl::unexpected(in_order(std::move(errors_)));
        return std::move(typed_);
    }

private:
    void report(std::string code, std::string message, std::string hint, Location where)
    {
        errors_.push_back({std::move(code), std::move(message), std::move(hint), std::move(where)});
    }

    /// By their place in the file; mistakes without a place keep their order behind.
    static Errors in_order(Errors errors)
    {
        std::stable_sort(errors.begin(), errors.end(), [](const Error& a, const Error& b) {
            const auto key = [](const Error& e) { return e.where.line > 0 ? e.where.line : 1 << 30; };
            return key(a) != key(b) ? key(a) < key(b) : a.where.column < b.where.column;
        });
        return errors;
    }

    std::vector<TypedImage> type_source()
    {
        const GraphNode& node = *current_;
        switch (node.kind) {
        case GraphNode::Kind::scene:
            return {{Signal::radiance, Over::scene, options_.extent},
                    {Signal::radiance, Over::sphere, {}},
                    {Signal::albedo, Over::table, {}},
                    {Signal::material, Over::table, {}},
                    {Signal::radiance, Over::table, {}}};
        case GraphNode::Kind::cube:
            return {{node.signal, Over::sphere, {}}};
        default:
            break;
        }
        const auto given = options_.picture_extents.find(node.name);
        const Extent extent = given == options_.picture_extents.end() ? options_.extent : given->second;
        check_extent(extent, node.name);
        return {{node.signal, Over::image, extent}};
    }

    std::vector<TypedImage> type_pass()
    {
        const PassDeclaration& pass = *current_->pass;
        generic_.reset();
        for (size_t i = 0; i < pass.inputs.size(); ++i)
            check_input(pass.inputs[i], current_->inputs[i]);
        check_derivations();
        std::vector<TypedImage> outputs;
        for (size_t i = 0; i < pass.outputs.size(); ++i) {
            const OutputPort& port = pass.outputs[i];
            TypedImage image;
            // A generic pass whose wire is missing or wrong was reported; radiance keeps what follows checkable.
            image.signal = port.signal == Signal::color ? generic_.value_or(Signal::radiance) : port.signal;
            image.extent = extent_of(port);
            check_extent(image.extent, current_->name + "." + port.name);
            check_codec(i, image.signal);
            outputs.push_back(image);
        }
        return outputs;
    }

    /// A layout may leave an output to a pass that computes it from other outputs and from the scene, wired by name.
    void check_derivations()
    {
        const PassDeclaration& pass = *current_->pass;
        const Layout* layout = layout_of(*current_);
        for (size_t i = 0; layout && i < layout->outputs.size(); ++i) {
            const Layout::Output& output = layout->outputs[i];
            if (output.derived_from.empty())
                continue;
            const PassPtr derivation = graph_.library().find(output.derived_from);
            const std::string place = fmt::format("layout `{}` of `{}`: `{}`", layout->name, pass.name, output.output);
            if (!derivation) {
                report("unknown_pass", fmt::format("{}: there is no pass `{}`", place, output.derived_from),
                       suggest(output.derived_from, graph_.library().names(), "passes"), output.where);
                continue;
            }
            if (derivation->find_output(output.output) < 0)
                report("unknown_output", fmt::format("{}: `{}` has no output of that name", place, derivation->name),
                       "name a pass whose output has the same name", output.where);
            for (const InputPort& port : derivation->inputs) {
                const int stored = pass.find_output(port.name);
                const bool is_wired = stored >= 0 && accepts(port.signal, pass.outputs[static_cast<size_t>(stored)].signal);
                if (!is_wired && !is_scene_port(port.name) && !port.is_optional)
                    report("input_missing", fmt::format("{}: nothing is called `{}`, which `{}` reads", place, port.name,
                                                        derivation->name),
                           "its inputs are outputs of the geometry pass or ports of the scene", output.where);
            }
        }
    }

    static bool is_scene_port(std::string_view port)
    {
        for (int i = 1; i < kScenePorts; ++i)
            if (port == name(static_cast<ScenePort>(i)))
                return true;
        return false;
    }

    bool is_known(ImageRef image) const
    {
        return image.node >= 0 && static_cast<size_t>(image.node) < typed_.images.size() &&
               static_cast<size_t>(image.output) < typed_.images[static_cast<size_t>(image.node)].size();
    }

    void check_input(const InputPort& port, const std::optional<Wire>& wire)
    {
        const std::string place = fmt::format("{}.{}", current_->name, port.name);
        if (!wire) {
            if (!port.is_optional)
                report("input_missing", fmt::format("{}: nothing is wired to it", place),
                       port.over == Over::scene
                           ? "wire the scene to it"
                           : fmt::format("wire {} of signal {} to it", over_text(port.over), info(port.signal).name),
                       current_->where);
            return;
        }
        if (!is_known(wire->from))
            return; // reported when the name was resolved
        const TypedImage& image = typed_.image(wire->from);
        const std::string from = graph_.image_name(wire->from);
        // A table may be an image that a pass makes.
        const bool fits = image.over == port.over || (port.over == Over::table && image.over == Over::image);
        if (!fits) {
            report(
                "over_mismatch",
                fmt::format("{}: expects {}, got {} from {}", place, over_text(port.over), over_text(image.over), from),
                image.over == Over::scene && port.over == Over::sphere
                    ? fmt::format("read {}.sky", from)
                    : fmt::format("wire {} to it", over_text(port.over)),
                wire->where);
            return;
        }
        if (port.over == Over::scene)
            return;
        if (!accepts(port.signal, image.signal)) {
            report("signal_mismatch",
                   fmt::format("{}: expects {}, got {} from {}", place, info(port.signal).name, info(image.signal).name,
                               from),
                   fix_for(port.signal, wire->from), wire->where);
            return;
        }
        if (port.signal != Signal::color)
            return;
        if (generic_ && *generic_ != image.signal) {
            report("generic_mismatch",
                   fmt::format("{}: got {} from {}, but another input of `{}` is {}", place, info(image.signal).name,
                               from, current_->name, info(*generic_).name),
                   "all generic inputs of a pass carry one signal", wire->where);
            return;
        }
        generic_ = image.signal;
    }

    /// What the offending image was made from, if its signal fits; else any image that fits, or the pass that turns one
    /// signal into the other.
    std::string fix_for(Signal wanted, ImageRef offending) const
    {
        const Signal got = typed_.image(offending).signal;
        std::string fix;
        if (const auto source = made_from(wanted, offending))
            fix = fmt::format("read {}", graph_.image_name(*source));
        else if (const auto other = latest_image(wanted))
            fix = fmt::format("read {}", graph_.image_name(*other));
        if (fix.empty() && wanted == Signal::display && got == Signal::radiance)
            return "put a tone_map between them";
        if (fix.empty())
            return fmt::format("no image of signal {} exists here", info(wanted).name);
        return wanted == Signal::radiance && got == Signal::display
                   ? fmt::format("{}, or put `{}` before the tone map", fix, current_->name)
                   : fix;
    }

    /// The nearest image upstream of `image` that a port of signal `wanted` accepts; breadth first.
    std::optional<ImageRef> made_from(Signal wanted, ImageRef image) const
    {
        std::vector<int> open = {image.node};
        for (size_t next = 0; next < open.size(); ++next) {
            for (const auto& wire : graph_.nodes()[static_cast<size_t>(open[next])].inputs) {
                if (!wire || !is_known(wire->from) || typed_.image(wire->from).over != Over::image)
                    continue;
                if (accepts(wanted, typed_.image(wire->from).signal))
                    return wire->from;
                if (std::find(open.begin(), open.end(), wire->from.node) == open.end())
                    open.push_back(wire->from.node);
            }
        }
        return std::nullopt;
    }

    std::optional<ImageRef> latest_image(Signal wanted) const
    {
        for (int node = static_cast<int>(typed_.images.size()) - 1; node >= 0; --node) {
            const auto& outputs = typed_.images[static_cast<size_t>(node)];
            for (size_t output = 0; output < outputs.size(); ++output)
                if (outputs[output].over == Over::image && accepts(wanted, outputs[output].signal))
                    return ImageRef{node, static_cast<int>(output)};
        }
        return std::nullopt;
    }

    Extent largest_input() const
    {
        Extent largest;
        for (size_t i = 0; i < current_->inputs.size(); ++i) {
            const auto& wire = current_->inputs[i];
            if (!wire || !is_known(wire->from) || typed_.image(wire->from).over != Over::image)
                continue;
            const Extent extent = typed_.image(wire->from).extent;
            if (static_cast<long long>(extent.width) * extent.height >
                static_cast<long long>(largest.width) * largest.height)
                largest = extent;
        }
        return largest == Extent{} ? options_.extent : largest;
    }

    Extent extent_of(const OutputPort& port) const
    {
        if (current_->pass->kind == PassKind::geometry)
            return options_.extent;
        if (port.texels)
            return {(*port.texels)[0], (*port.texels)[1]};
        Extent base = largest_input();
        if (!port.size_of.empty()) {
            const auto& wire = current_->inputs[static_cast<size_t>(current_->pass->find_input(port.size_of))];
            if (wire && is_known(wire->from))
                base = typed_.image(wire->from).extent;
        }
        if (current_->size_of && is_known(*current_->size_of))
            return typed_.image(*current_->size_of).extent;
        const Ratio scale = current_->scale.value_or(port.scale);
        const auto scaled = [&](int texels) {
            const long long product = static_cast<long long>(texels) * scale.p;
            return static_cast<int>(std::clamp<long long>((product + scale.q - 1) / scale.q, 1, 1 << 30));
        };
        return {scaled(base.width), scaled(base.height)};
    }

    void check_extent(Extent extent, const std::string& what)
    {
        if (extent.width < 1 || extent.height < 1) {
            report("extent_empty", fmt::format("{} would be {}x{} texels", what, extent.width, extent.height),
                   "both sides must be at least 1", current_->where);
        } else if (std::max(extent.width, extent.height) > options_.device.max_texture_size) {
            // A frame that is too large is one mistake, not one of each image of its size.
            const bool is_frame = extent == options_.extent;
            if (is_frame_reported_)
                return;
            is_frame_reported_ = is_frame;
            errors_.push_back(
                {"extent_too_large",
                 fmt::format("{} would be {}x{} texels", is_frame ? "the frame" : what, extent.width, extent.height),
                 fmt::format("this device allows at most {} each way", options_.device.max_texture_size),
                 is_frame ? Location{} : current_->where, Fault::machine});
        }
    }

    void check_codec(size_t output, Signal signal)
    {
        const std::string& codec = current_->codecs[output];
        if (codec.empty())
            return;
        if (const Codec* found = find_codec(signal, codec)) {
            if (!can_store(*current_->pass, *found))
                report("unknown_codec",
                       fmt::format("{}.{}: `{}` cannot store the depth of a pass of this kind", current_->name,
                                   current_->pass->outputs[output].name, codec),
                       "a full-screen pass has no depth buffer: r32f",
                       current_->where);
            return;
        }
        report("unknown_codec",
               fmt::format("{}.{} is {}, which no codec `{}` stores", current_->name,
                           current_->pass->outputs[output].name, info(signal).name, codec),
               suggest(codec, codec_names(signal), "codecs"), current_->where);
    }

    void check_output(const GraphOutput& output)
    {
        if (!is_known(output.from))
            return;
        if (typed_.image(output.from).over != Over::image) {
            report("over_mismatch",
                   fmt::format("output `{}`: expects an image, got {} from {}", output.name,
                               over_text(typed_.image(output.from).over), graph_.image_name(output.from)),
                   "name an image that a pass makes", output.where);
        }
    }

    const Graph& graph_;
    const CompileOptions& options_;
    Errors errors_;
    TypedGraph typed_;
    const GraphNode* current_ = nullptr;
    std::optional<Signal> generic_;
    bool is_frame_reported_ = false;
};

} // namespace

Result<TypedGraph> validate(const Graph& graph, const CompileOptions& options)
{
    return Validator(graph, options).run();
}

} // namespace passgraph::compiler
