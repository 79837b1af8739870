// Draws and compares ladders.
#include "tool/accuracy/compared.hpp"

#include <algorithm>

#include "support/catch.hpp"
#include "support/test_context.hpp"
#include "tool/accuracy/probes.hpp"

namespace passgraph::test {

using namespace accuracy;

const PassLibrary& probed_library()
{
    static const PassLibrary all = [] {
        const auto made = with_probes(builtin_passes(), std::string(PASSGRAPH_SOURCE_DIR) + "/passes/common");
        if (!made)
            FAIL(to_text(made.error()));
        return *made;
    }();
    return all;
}

std::vector<MeasuredRung> compared(const Ladder& ladder)
{
    constexpr Extent kExtent{320, 192};
    const Inputs inputs = ladder.make_inputs(kExtent);
    const Truth truth = ladder.find_truth(inputs, kExtent);
    std::vector<MeasuredRung> rungs;
    for (const Rung& rung : ladder.rungs) {
        auto result = compare_rung(ladder, rung, inputs, truth, probed_library(), test_context().loader());
        if (!result)
            FAIL(ladder.name + "." + rung.name + "\n" + to_text(result.error()));
        rungs.push_back(std::move(result->rung));
    }
    return rungs;
}

const Ladder& ladder_called(const std::string& name)
{
    const auto& all = all_ladders();
    const auto found = std::find_if(all.begin(), all.end(), [&](const Ladder& ladder) { return ladder.name == name; });
    REQUIRE(found != all.end());
    return *found;
}

const MeasuredRung& rung_called(const std::vector<MeasuredRung>& rungs, const std::string& name)
{
    const auto found = std::find_if(rungs.begin(), rungs.end(), [&](const MeasuredRung& rung) { return rung.rung.name == name; });
    REQUIRE(found != rungs.end());
    return *found;
}

double figure_of(const MeasuredRung& rung, const std::string& name)
{
    const auto found = std::find_if(rung.figures.begin(), rung.figures.end(), [&](const Figure& one) { return one.name == name; });
    REQUIRE(found != rung.figures.end());
    return found->value;
}

} // namespace passgraph::test
