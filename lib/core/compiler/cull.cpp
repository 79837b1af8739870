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
    std::set<std::string> were_live;
    const std::vector<bool> was_live = find_live(before);
    for (int index = 0; index < before.node_count(); ++index)
        if (was_live[static_cast<size_t>(index)])
            were_live.insert(before.node(index).name);
    const auto reason_of = [&](const std::string& pass) -> std::string {
        for (const Plan::Decision& decision : special.decisions)
            if (decision.what == pass)
                return decision.reason;
        return were_live.contains(pass) ? "nothing needs it here" : "no output needs it";
    };
    Liveness live{find_live(graph), {}};
    if (!is_on)
        live.is_live.assign(live.is_live.size(), true);
    for (int index = 0; index < graph.node_count(); ++index)
        if (!live.is_live[static_cast<size_t>(index)] && graph.is_pass(index))
            live.culled.push_back({graph.node(index).name, reason_of(graph.node(index).name)});
    return live;
}

} // namespace passgraph::compiler
