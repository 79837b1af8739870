// The passes that an output depends on, directly or not.
//
// Producers are declared before consumers, so one backward sweep is enough: when a pass is visited, all its readers have
// been.  O(passes + reads).
#include "core/compiler/ir.hpp"

namespace passgraph::compiler {

Liveness cull(const TypedGraph& graph, bool is_on)
{
    Liveness live;
    live.is_live.assign(static_cast<size_t>(graph.node_count()), !is_on);
    for (const GraphOutput& output : graph.outputs)
        live.is_live[static_cast<size_t>(output.from.node)] = true;
    for (const TypedGraph::Watch& watch : graph.watches) // of passes that are needed
        live.is_live[static_cast<size_t>(watch.counter)] = true;
    for (int index = graph.node_count() - 1; index >= 0; --index) {
        if (!live.is_live[static_cast<size_t>(index)])
            continue;
        for (const auto& wire : graph.node(index).inputs)
            if (wire)
                live.is_live[static_cast<size_t>(wire->from.node)] = true;
    }
    for (int index = 0; index < graph.node_count(); ++index)
        if (!live.is_live[static_cast<size_t>(index)] && graph.is_pass(index))
            live.culled.push_back({graph.node(index).name, "no output needs it"});
    return live;
}

} // namespace passgraph::compiler
