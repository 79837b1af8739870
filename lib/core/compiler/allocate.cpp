// Lifetimes to slots: images that never live together share memory.
#include <algorithm>

#include "core/compiler/ir.hpp"

namespace passgraph::compiler {

std::vector<Lifetime> find_lifetimes(const TypedGraph& graph, const Encoding& encoding, const Draws& draws,
                                     const Order& order)
{
    std::map<TargetRef, Lifetime> lifetimes;
    const auto keep = [&](ImageRef image, size_t until) {
        for (const TargetRef target : encoding.targets_of(image))
            if (const auto found = lifetimes.find(target); found != lifetimes.end())
                found->second.last = static_cast<int>(until);
    };
    for (size_t time = 0; time < order.size(); ++time) {
        const Draw& draw = draws.draws[static_cast<size_t>(order[time])];
        for (const TargetRef target : targets_of(encoding, draw))
            lifetimes[target] = {target, static_cast<int>(time), static_cast<int>(time)};
        for (const ExternalRead& read : external_reads(graph, draw.nodes))
            keep(read.image, time);
        if (draw.tested_depth)
            lifetimes.at(*draw.tested_depth).last = static_cast<int>(time);
    }
    // The host reads outputs after the frame.
    for (const GraphOutput& output : graph.outputs)
        keep(output.from, order.size());
    std::vector<Lifetime> sorted;
    for (const auto& [target, lifetime] : lifetimes)
        sorted.push_back(lifetime);
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const Lifetime& a, const Lifetime& b) { return a.first < b.first; });
    return sorted;
}

/// Interval colouring, left edge first, among slots of exactly equal descriptor.
///
/// An image takes a new slot only when every slot of its kind holds an image that is still needed, so the number of slots of
/// a kind is the largest number of its images alive at one time: no fewer can do.  O(images * slots).
Slots allocate(const TypedGraph& graph, const Encoding& encoding, const std::vector<Lifetime>& lifetimes,
               bool is_shared)
{
    Slots result;
    std::vector<int> busy_until;
    for (const Lifetime& lifetime : lifetimes) {
        const Format format = encoding.target(lifetime.target).format;
        const Extent extent = graph.images[static_cast<size_t>(lifetime.target.node)].front().extent;
        const std::int64_t bytes = static_cast<std::int64_t>(bytes_per_texel(format)) * extent.width * extent.height;
        result.bytes_unshared += bytes;
        size_t slot = 0;
        while (slot < result.slots.size() &&
               !(is_shared && result.slots[slot].format == format && result.slots[slot].extent == extent &&
                 busy_until[slot] < lifetime.first))
            ++slot;
        if (slot == result.slots.size()) {
            result.slots.push_back({format, extent, {}});
            busy_until.push_back(0);
            result.bytes += bytes;
        }
        busy_until[slot] = lifetime.last;
        result.slots[slot].images.push_back(target_name(graph, encoding, lifetime.target));
        result.slot_of[lifetime.target] = static_cast<int>(slot);
    }
    return result;
}

} // namespace passgraph::compiler
