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
    const auto derived = derive(*typed);                                    // derive.cpp    what layouts leave out
    const auto whole = watch(derived, options);                             // watch.cpp     is anything bright?
    const auto encoding = encode(whole);                                    // encode.cpp    stored how
    const auto live = cull(whole, options.cull);                            // cull.cpp      nothing unread
    const auto fused = fuse(whole, encoding, live, options);                // fuse.cpp      in how few draws
    const auto draws = split_by_depth(whole, encoding, fused, options.specialise); // split.cpp  where
    const auto order = order_draws(whole, draws);                           // order.cpp     when
    const auto conditions = find_conditions(whole, encoding, draws, order, options); // skip.cpp  unless all is black
    const auto lifetimes = find_lifetimes(whole, encoding, draws, order);   // allocate.cpp  needed from when to when
    const auto slots = allocate(whole, encoding, lifetimes, options.alias); // allocate.cpp  in which memory
    Plan plan = lower(whole, encoding, draws, order, conditions, slots, options);       // lower.cpp     bind, clear, draw
    plan.culled = live.culled;
    return plan;
}

} // namespace passgraph
