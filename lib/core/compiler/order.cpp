// A topological order of the draws that keeps the declaration's order where it can.
#include <algorithm>
#include <cassert>

#include "core/compiler/ir.hpp"

namespace passgraph::compiler {

/// Kahn's algorithm, always taking the ready draw declared first.  O(draws^2), and draws are few.
Order order_draws(const TypedGraph& graph, const Draws& draws)
{
    const size_t count = draws.draws.size();
    std::vector<std::vector<int>> producers(count);
    for (size_t i = 0; i < count; ++i)
        for (const ExternalRead& read : external_reads(graph, draws.draws[i].nodes))
            if (const int from = draws.draw_of[static_cast<size_t>(read.image.node)]; from >= 0)
                producers[i].push_back(from);
    Order order;
    std::vector<bool> is_done(count, false);
    while (order.size() < count) {
        [[maybe_unused]] const size_t before = order.size();
        for (size_t i = 0; i < count; ++i) {
            const bool is_ready = !is_done[i] && std::all_of(producers[i].begin(), producers[i].end(),
                                                             [&](int p) { return is_done[static_cast<size_t>(p)]; });
            if (!is_ready)
                continue;
            is_done[i] = true;
            order.push_back(static_cast<int>(i));
            break;
        }
        assert(order.size() > before && "fusion made draws that wait for each other");
    }
    return order;
}

} // namespace passgraph::compiler
