// What a plan's rows say when asked.
#include "passgraph/core/plan.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace passgraph {

std::vector<int> Plan::Step::written_slots() const
{
    std::vector<int> slots;
    for (const Target& target : targets)
        slots.push_back(target.slot);
    if (depth_slot >= 0)
        slots.push_back(depth_slot);
    return slots;
}

bool Plan::Step::writes(int slot) const
{
    const std::vector<int> slots = written_slots();
    return std::find(slots.begin(), slots.end(), slot) != slots.end();
}

std::string why_skipped(const Plan& plan, std::size_t step, bool was_skipped)
{
    const Plan::Step& row = plan.steps[step];
    if (!was_skipped)
        return "";
    if (row.skipped_by < 0)
        return "not drawn: its scout found nothing";
    return fmt::format("{}: every pixel of {} is black",
                       row.when_skipped.empty() ? "not drawn" : fmt::format("drawn without {}", row.black_images),
                       plan.queries[static_cast<std::size_t>(row.skipped_by)].images);
}

} // namespace passgraph
