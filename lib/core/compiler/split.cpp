// Draws in two parts: where a depth buffer holds a surface, and where it holds none.
//
// A pass that does something only where there is geometry, or only where there is none, costs nothing elsewhere when the
// depth test keeps its pixels apart; branches in a shader do not on every device.
#include <algorithm>

#include "core/compiler/ir.hpp"

namespace passgraph::compiler {
namespace {

/// Geometry passes that a node's inputs come from, through derivations and other passes of its own draw.
void find_geometry(const TypedGraph& graph, int node, std::set<int>& found)
{
    for (const auto& wire : graph.node(node).inputs) {
        if (!wire || !graph.is_pass(wire->from.node))
            continue;
        if (graph.node(wire->from.node).pass->kind == PassKind::geometry)
            found.insert(wire->from.node);
        else
            find_geometry(graph, wire->from.node, found);
    }
}

std::optional<TargetRef> tested_depth(const TypedGraph& graph, const Encoding& encoding, const Draw& draw)
{
    std::set<int> geometry;
    for (const int node : draw.nodes)
        if (graph.node(node).pass->only_where != OnlyWhere::everywhere)
            find_geometry(graph, node, geometry);
    if (geometry.size() != 1)
        return std::nullopt;
    const int node = *geometry.begin();
    const auto extent = [&](int of) { return graph.images[static_cast<size_t>(of)].front().extent; };
    if (!(extent(node) == extent(draw.nodes.front())))
        return std::nullopt;
    return TargetRef{node, encoding.depth_target[static_cast<size_t>(node)]};
}

} // namespace

Draws split_by_depth(const TypedGraph& graph, const Encoding& encoding, Draws draws, bool is_on)
{
    for (Draw& draw : draws.draws)
        if (is_on && graph.node(draw.nodes.front()).pass->kind == PassKind::image)
            draw.tested_depth = tested_depth(graph, encoding, draw);
    return draws;
}

} // namespace passgraph::compiler
