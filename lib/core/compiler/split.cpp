// Draws in two parts: where a depth buffer holds a surface, and where it holds none.
//
// A pass that does something only where there is geometry, or only where there is none, costs nothing elsewhere when the
// depth test keeps its pixels apart; branches in a shader do not on every device.
#include <algorithm>

#include "core/compiler/ir.hpp"

namespace passgraph::compiler {
namespace {

std::optional<TargetRef> tested_depth(const TypedGraph& graph, const Encoding& encoding, const Draw& draw)
{
    std::set<int> geometry;
    for (const int node : draw.nodes)
        if (graph.node(node).pass->only_where != OnlyWhere::everywhere)
            geometry.merge(geometry_of(graph, node));
    if (geometry.size() != 1)
        return std::nullopt;
    const int node = *geometry.begin();
    const auto extent = [&](int of) { return graph.images[static_cast<size_t>(of)].front().extent; };
    if (!(extent(node) == extent(draw.stored.front().node)))
        return std::nullopt;
    return TargetRef{node, encoding.depth_target[static_cast<size_t>(node)]};
}

} // namespace

std::set<int> geometry_of(const TypedGraph& graph, int node)
{
    std::set<int> found;
    std::set<int> seen = {node};
    std::vector<int> open = {node};
    while (!open.empty()) {
        const GraphNode& reader = graph.node(open.back());
        open.pop_back();
        for (const auto& wire : reader.inputs) {
            if (!wire || !graph.is_pass(wire->from.node) || !seen.insert(wire->from.node).second)
                continue;
            const bool is_geometry = graph.node(wire->from.node).pass->kind == PassKind::geometry;
            (is_geometry ? found : seen).insert(wire->from.node);
            if (!is_geometry)
                open.push_back(wire->from.node);
        }
    }
    return found;
}

Draws split_by_depth(const TypedGraph& graph, const Encoding& encoding, Draws draws, bool is_on)
{
    for (Draw& draw : draws.draws)
        if (is_on && graph.node(draw.nodes.front()).pass->kind == PassKind::image)
            draw.tested_depth = tested_depth(graph, encoding, draw);
    return draws;
}

} // namespace passgraph::compiler
