// What a layout leaves out is computed from what it stores: derivation passes are inserted behind geometry passes.
#include <algorithm>
#include <cassert>

#include "core/compiler/ir.hpp"
#include "core/graph_settings.hpp"

namespace passgraph::compiler {
namespace {

/// Copies a graph node by node; what reads a derived output reads the pass that computes it.
class Derivation {
public:
    explicit Derivation(const TypedGraph& graph) : graph_(graph)
    {
        result_.outputs = graph.outputs;
        result_.library = graph.library;
        for (const GraphNode& node : graph.nodes)
            for (const auto& wire : node.inputs)
                if (wire)
                    read_.insert(wire->from);
        for (const GraphOutput& output : graph.outputs)
            read_.insert(output.from);
    }

    TypedGraph run()
    {
        for (int index = 0; index < graph_.node_count(); ++index)
            copy(index);
        for (GraphOutput& output : result_.outputs)
            output.from = moved_.at(output.from);
        return std::move(result_);
    }

private:
    int append(GraphNode node, std::vector<TypedImage> images)
    {
        result_.nodes.push_back(std::move(node));
        result_.images.push_back(std::move(images));
        return static_cast<int>(result_.nodes.size()) - 1;
    }

    void copy(int index)
    {
        GraphNode node = graph_.node(index);
        for (auto& wire : node.inputs)
            if (wire)
                wire->from = moved_.at(wire->from);
        if (node.size_of)
            node.size_of = moved_.at(*node.size_of);
        const auto& images = graph_.images[static_cast<size_t>(index)];
        const int at = append(std::move(node), images);
        for (int output = 0; output < static_cast<int>(images.size()); ++output)
            moved_[{index, output}] = {at, output};
        const Layout* layout = graph_.is_pass(index) ? layout_of(graph_.node(index)) : nullptr;
        derived_.clear();
        for (int output = 0; layout && output < static_cast<int>(images.size()); ++output)
            if (read_.contains({index, output}))
                moved_[{index, output}] = stored_or_derived(*layout, index, output);
    }

    /// The image that stands for an output of the geometry node `index`.
    ImageRef stored_or_derived(const Layout& layout, int index, int output)
    {
        const GraphNode& geometry = graph_.node(index);
        const Layout::Output* entry = layout.find(geometry.pass->outputs[static_cast<size_t>(output)].name);
        if (!entry || entry->derived_from.empty())
            return moved_.at({index, output});
        const auto known = derived_.find(entry->derived_from);
        const int node = known != derived_.end() ? known->second : derive(layout, index, entry->derived_from);
        const GraphNode& derived = result_.node(node);
        const int own = derived.pass->find_output(entry->output);
        const int from = own >= 0 ? own : 0;
        result_.nodes[static_cast<size_t>(node)].codecs[static_cast<size_t>(from)] =
            geometry.codecs[static_cast<size_t>(output)];
        return {node, from};
    }

    /// Inputs are wired by name: to outputs of the geometry pass, stored or derived themselves, and to the scene's ports.
    int derive(const Layout& layout, int index, const std::string& pass_name)
    {
        const GraphNode& geometry = graph_.node(index);
        const PassPtr pass = graph_.library->find(pass_name);
        assert(pass && "validate finds unknown derivations");
        GraphNode node = node_of(pass, geometry.name + "." + pass_name, geometry.where);
        const ImageRef scene = moved_.at(geometry.inputs.front()->from);
        for (size_t i = 0; i < pass->inputs.size(); ++i) {
            const std::string& port = pass->inputs[i].name;
            if (const int output = geometry.pass->find_output(port); output >= 0)
                node.inputs[i] = Wire{stored_or_derived(layout, index, output), geometry.where};
            for (int from_scene = 1; from_scene < kScenePorts; ++from_scene)
                if (port == name(static_cast<ScenePort>(from_scene)))
                    node.inputs[i] = Wire{{scene.node, from_scene}, geometry.where};
        }
        const Extent extent = graph_.images[static_cast<size_t>(index)].front().extent;
        std::vector<TypedImage> images;
        for (const OutputPort& output : pass->outputs)
            images.push_back({output.signal, Over::image, extent});
        return derived_[pass_name] = append(std::move(node), std::move(images));
    }

    const TypedGraph& graph_;
    TypedGraph result_;
    std::set<ImageRef, ImageLess> read_;
    std::map<ImageRef, ImageRef, ImageLess> moved_; ///< old image to new
    std::map<std::string, int> derived_;            ///< of the geometry node at hand: derivation to node
};

} // namespace

const Layout* layout_of(const GraphNode& node)
{
    const int selection = node.pass->find_selection("layout");
    if (selection < 0 || node.pass->layouts.empty())
        return nullptr;
    return &node.pass->layouts[static_cast<size_t>(node.selections[static_cast<size_t>(selection)])];
}

TypedGraph derive(const TypedGraph& graph) { return Derivation(graph).run(); }

} // namespace passgraph::compiler
