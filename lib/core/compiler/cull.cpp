// The passes that an output depends on, directly or not.
//
// Producers are declared before consumers, so one backward sweep is enough: when a pass is visited, all its readers have
// been.  O(passes + reads).
#include "core/compiler/ir.hpp"

namespace passgraph::compiler {
namespace {

std::vector<bool> find_live(const TypedGraph& graph)
{
    std::vector<bool> is_live(static_cast<size_t>(graph.node_count()), false);
    for (const GraphOutput& output : graph.outputs)
        is_live[static_cast<size_t>(output.from.node)] = true;
    for (int index = graph.node_count() - 1; index >= 0; --index) {
        if (!is_live[static_cast<size_t>(index)])
            continue;
        for (const auto& wire : graph.node(index).inputs)
            if (wire)
                is_live[static_cast<size_t>(wire->from.node)] = true;
    }
    return is_live;
}

} // namespace

Liveness cull(const Specialised& special, const TypedGraph& before, bool is_on)
{
    const TypedGraph& graph = special.graph;
    const auto reason_of = [&](const std::string& pass, bool was_live) -> std::string {
        for (const Plan::Decision& decision : special.decisions)
            if (decision.what == pass)
                return decision.reason;
        return was_live ? "nothing needs it here" : "no output needs it";
    };
    Liveness live;
    const std::vector<bool> was_live = find_live(before);
    live.is_live = is_on ? find_live(graph) : std::vector<bool>(was_live.size(), true);
    for (int index = 0; index < graph.node_count(); ++index)
        if (const auto i = static_cast<size_t>(index); !live.is_live[i] && graph.is_pass(index))
            live.culled.push_back({graph.node(index).name, reason_of(graph.node(index).name, was_live[i])});
    return live;
}

} // namespace passgraph::compiler
