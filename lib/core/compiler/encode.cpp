// Chooses how each image is stored: the node's own codec, its layout's places, or a target with the signal's default.
#include <algorithm>

#include <fmt/format.h>

#include "core/compiler/ir.hpp"

namespace passgraph::compiler {
namespace {

Codec default_codec(const GraphNode& node, Signal signal)
{
    const auto& codecs = codecs_of(signal);
    return *std::find_if(codecs.begin(), codecs.end(), [&](const Codec& codec) { return can_store(*node.pass, codec); });
}

/// The targets of one pass, and where its outputs stand in them.
class PassStorage {
public:
    PassStorage(const GraphNode& node, const std::vector<TypedImage>& images, const std::set<int>& handed_out)
        : node_(node), handed_out_(handed_out), layout_(layout_of(node))
    {
        if (layout_)
            targets = layout_->targets;
        for (size_t output = 0; output < images.size(); ++output)
            storage.push_back(choose(output, images[output].signal));
        drop_unused_targets();
        if (node.pass->kind == PassKind::geometry)
            depth_target = find_depth_target();
    }

    std::vector<Storage> storage;
    std::vector<Layout::Target> targets;
    int depth_target = -1;

private:
    Storage choose(size_t output, Signal signal)
    {
        const std::string& name = node_.pass->outputs[output].name;
        const Layout::Output* entry = layout_ ? layout_->find(name) : nullptr;
        if (entry && !entry->derived_from.empty())
            return {};
        if (const Codec* own = find_codec(signal, node_.codecs[output]))
            return in_own_target(name, *own);
        if (entry && !(handed_out_.contains(static_cast<int>(output)) && is_shared(*entry)))
            return {entry->codec, entry->places};
        if (entry && entry->codec.packing != Packing::plain)
            return in_own_target(name, entry->codec);
        return in_own_target(name, default_codec(node_, signal));
    }

    /// Other outputs stand in the same targets, or this one in several.
    bool is_shared(const Layout::Output& entry) const
    {
        for (const Layout::Output& other : layout_->outputs)
            for (const Layout::Place& place : other.places)
                if (&other != &entry && place.target == entry.places.front().target)
                    return true;
        return entry.places.size() > 1;
    }

    Storage in_own_target(const std::string& name, const Codec& codec)
    {
        targets.push_back({name, codec.format});
        const auto channels = static_cast<size_t>(channel_count(codec.format));
        return {codec, {{static_cast<int>(targets.size()) - 1, std::string("rgba").substr(0, channels)}}};
    }

    /// A codec chosen for one output may leave nothing in the target that its layout had for it.
    void drop_unused_targets()
    {
        std::vector<int> kept(targets.size(), -1);
        for (const Storage& image : storage)
            for (const Layout::Place& place : image.places)
                kept[static_cast<size_t>(place.target)] = 0;
        std::vector<Layout::Target> used;
        for (size_t i = 0; i < targets.size(); ++i) {
            if (kept[i] < 0)
                continue;
            kept[i] = static_cast<int>(used.size());
            used.push_back(targets[i]);
        }
        targets = std::move(used);
        for (Storage& image : storage)
            for (Layout::Place& place : image.places)
                place.target = kept[static_cast<size_t>(place.target)];
    }

    /// Geometry tests against a depth buffer, whether or not anybody reads it.
    int find_depth_target()
    {
        for (size_t i = 0; i < targets.size(); ++i)
            if (is_depth(targets[i].format))
                return static_cast<int>(i);
        targets.push_back({"depth_buffer", Format::depth32f});
        return static_cast<int>(targets.size()) - 1;
    }

    const GraphNode& node_;
    const std::set<int>& handed_out_; ///< outputs that the host reads: each alone in its target
    const Layout* layout_;
};

} // namespace

std::set<TargetRef> Encoding::targets_of(ImageRef image) const
{
    std::set<TargetRef> result;
    for (const Layout::Place& place : of(image).places)
        result.insert({image.node, place.target});
    return result;
}

std::set<TargetRef> targets_of(const Encoding& encoding, const Draw& draw)
{
    std::set<TargetRef> result;
    for (const ImageRef image : draw.stored)
        result.merge(encoding.targets_of(image));
    for (const int node : draw.nodes)
        if (const int depth = encoding.depth_target[static_cast<size_t>(node)]; depth >= 0)
            result.insert({node, depth});
    return result;
}

std::string target_name(const TypedGraph& graph, const Encoding& encoding, TargetRef target)
{
    std::vector<std::string> names;
    const auto& storage = encoding.storage[static_cast<size_t>(target.node)];
    for (int output = 0; output < static_cast<int>(storage.size()); ++output)
        if (encoding.targets_of({target.node, output}).contains(target))
            names.push_back(graph.name({target.node, output}));
    if (names.empty())
        return graph.node(target.node).name + "." + encoding.target(target).name;
    return fmt::format("{}", fmt::join(names, " + "));
}

Encoding encode(const TypedGraph& graph)
{
    Encoding encoding;
    for (int index = 0; index < graph.node_count(); ++index) {
        const auto& images = graph.images[static_cast<size_t>(index)];
        if (graph.is_pass(index)) {
            std::set<int> handed_out;
            for (const GraphOutput& output : graph.outputs)
                if (output.from.node == index)
                    handed_out.insert(output.from.output);
            PassStorage stored(graph.node(index), images, handed_out);
            encoding.storage.push_back(std::move(stored.storage));
            encoding.targets.push_back(std::move(stored.targets));
            encoding.depth_target.push_back(stored.depth_target);
            continue;
        }
        // What a host supplies is uploaded in binary32.
        std::vector<Storage>& storage = encoding.storage.emplace_back();
        std::vector<Layout::Target>& targets = encoding.targets.emplace_back();
        for (int output = 0; output < static_cast<int>(images.size()); ++output) {
            storage.push_back({{"rgba32f", Format::rgba32f, Packing::plain}, {{output, "rgba"}}});
            targets.push_back({graph.name({index, output}), Format::rgba32f});
        }
        encoding.depth_target.push_back(-1);
    }
    return encoding;
}

} // namespace passgraph::compiler
