// A topological order of the draws that keeps the declaration's order where it can.  What counts pixels comes as early as it
// can: only draws behind it are spared.
#include <algorithm>
#include <cassert>

#include "core/compiler/ir.hpp"

namespace passgraph::compiler {

/// Kahn's algorithm, always taking the ready draw declared first, of those that count if any is ready.  O(draws^2), and draws
/// are few.
Order order_draws(const TypedGraph& graph, const Draws& draws)
{
    const size_t count = draws.draws.size();
    std::vector<std::vector<int>> producers(count);
    for (size_t i = 0; i < count; ++i)
        for (const ExternalRead& read : external_reads(graph, draws.draws[i].nodes))
            if (const int from = draws.draw_of[static_cast<size_t>(read.image.node)]; from >= 0)
                producers[i].push_back(from);
    const auto counts = [&](size_t i) {
        return std::any_of(graph.watches.begin(), graph.watches.end(), [&](const TypedGraph::Watch& watch) {
            return draws.draw_of[static_cast<size_t>(watch.counter)] == static_cast<int>(i);
        });
    };
    Order order;
    std::vector<bool> is_done(count, false);
    while (order.size() < count) {
        size_t next = count;
        for (size_t i = 0; i < count; ++i) {
            const bool is_ready = !is_done[i] && std::all_of(producers[i].begin(), producers[i].end(),
                                                             [&](int p) { return is_done[static_cast<size_t>(p)]; });
            if (is_ready && (next == count || (counts(i) && !counts(next))))
                next = i;
        }
        assert(next < count && "fusion made draws that wait for each other");
        is_done[next] = true;
        order.push_back(static_cast<int>(next));
    }
    return order;
}

} // namespace passgraph::compiler
