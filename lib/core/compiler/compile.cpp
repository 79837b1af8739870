// The compiler's table of contents.
#include "passgraph/core/compile.hpp"

#include "core/compiler/ir.hpp"

namespace passgraph {

Result<Plan> compile(const Graph& graph, const CompileOptions& options)
{
    using namespace compiler;
    const auto typed = validate(graph, options); // validate.cpp  every mistake at once
    if (!typed)
        return tl::unexpected(typed.error());
    const auto whole = derive(*typed);                                      // derive.cpp    what layouts leave out
    const auto special = specialise(whole, options);                        // specialise.cpp what is needed here
    const TypedGraph& needed = special.graph;
    const auto encoding = encode(needed);                                   // encode.cpp    stored how
    const auto live = cull(special, whole, options.cull);                   // cull.cpp      nothing unread
    const auto fused = fuse(needed, encoding, live, options);               // fuse.cpp      in how few draws
    const auto draws = split_by_depth(needed, encoding, fused, options.specialise); // split.cpp  where
    const auto order = order_draws(needed, draws);                          // order.cpp     when
    const auto conditions = find_conditions(special, encoding, draws, order, options); // skip.cpp  unless all is black
    const auto lifetimes = find_lifetimes(needed, encoding, draws, order);  // allocate.cpp  needed from when to when
    const auto slots = allocate(needed, encoding, lifetimes, options.alias); // allocate.cpp  in which memory
    Plan plan = lower(special, encoding, draws, order, conditions, slots, options); // lower.cpp  bind, clear, draw
    plan.culled = live.culled;
    plan.decisions = special.decisions;
    if (options.specialise)
        plan.facts = options.facts;
    return plan;
}

} // namespace passgraph
