// Chooses how each image is stored: the node's own codec, its layout's, or the signal's default.
#include <algorithm>

#include "core/compiler/ir.hpp"

namespace passgraph::compiler {
namespace {

std::string_view layout_codec(const GraphNode& node, std::string_view output)
{
    const int selection = node.pass->find_selection("layout");
    if (selection < 0 || node.pass->layouts.empty())
        return "";
    const Layout& layout = node.pass->layouts[static_cast<size_t>(node.selections[static_cast<size_t>(selection)])];
    for (const auto& [name, codec] : layout.codecs)
        if (name == output)
            return codec;
    return "";
}

Codec choose(const GraphNode& node, size_t output, Signal signal)
{
    if (const Codec* own = find_codec(signal, node.codecs[output]))
        return *own;
    if (const Codec* from_layout = find_codec(signal, layout_codec(node, node.pass->outputs[output].name));
        from_layout && can_store(*node.pass, signal, *from_layout))
        return *from_layout;
    const auto& codecs = codecs_of(signal);
    return *std::find_if(codecs.begin(), codecs.end(),
                         [&](const Codec& codec) { return can_store(*node.pass, signal, codec); });
}

} // namespace

Encoding encode(const TypedGraph& graph)
{
    Encoding encoding;
    for (int index = 0; index < graph.node_count(); ++index) {
        std::vector<Codec>& codecs = encoding.codecs.emplace_back();
        const auto& images = graph.images[static_cast<size_t>(index)];
        for (size_t output = 0; output < images.size(); ++output) {
            // What a host supplies is uploaded in binary32.
            codecs.push_back(graph.is_pass(index) ? choose(graph.node(index), output, images[output].signal)
                                                  : Codec{"rgba32f", Format::rgba32f, Packing::plain});
        }
    }
    return encoding;
}

} // namespace passgraph::compiler
