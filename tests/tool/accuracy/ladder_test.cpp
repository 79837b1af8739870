// Every ladder: what is derived of its errors, and the order that is claimed.
#include <algorithm>
#include <set>

#include "support/catch.hpp"
#include "support/test_context.hpp"
#include "tool/accuracy/run.hpp"
#include "tool/accuracy/probes.hpp"

using namespace passgraph;
using namespace passgraph::accuracy;

namespace {

const PassLibrary& library()
{
    static const PassLibrary all = [] {
        const auto made = with_probes(builtin_passes(), std::string(PASSGRAPH_SOURCE_DIR) + "/passes/common");
        if (!made)
            FAIL(to_text(made.error()));
        return *made;
    }();
    return all;
}

// Four cells of bright texels in each direction, and a strip of every distance.
constexpr Extent kExtent{320, 192};

std::vector<MeasuredRung> compared(const Ladder& ladder)
{
    const Inputs inputs = ladder.make_inputs(kExtent);
    const Truth truth = ladder.find_truth(inputs, kExtent);
    std::vector<MeasuredRung> rungs;
    for (const Rung& rung : ladder.rungs) {
        auto result = compare_rung(ladder, rung, inputs, truth, library(), test::test_context().loader());
        if (!result)
            FAIL(ladder.name + "." + rung.name + "\n" + to_text(result.error()));
        rungs.push_back(std::move(result->rung));
    }
    return rungs;
}

const Ladder& ladder_called(const std::string& name)
{
    const auto& all = all_ladders();
    return *std::find_if(all.begin(), all.end(), [&](const Ladder& ladder) { return ladder.name == name; });
}

const MeasuredRung& rung_called(const std::vector<MeasuredRung>& rungs, const std::string& name)
{
    return *std::find_if(rungs.begin(), rungs.end(), [&](const MeasuredRung& rung) { return rung.rung.name == name; });
}

double figure(const MeasuredRung& rung, const std::string& name)
{
    const auto found = std::find_if(rung.figures.begin(), rung.figures.end(), [&](const Figure& one) { return one.name == name; });
    REQUIRE(found != rung.figures.end());
    return found->value;
}

} // namespace

TEST_CASE("every rung is within its derived bound, and no rung is less exact than its order claims", "[accuracy]")
{
    for (const Ladder& ladder : all_ladders()) {
        const std::vector<MeasuredRung> rungs = compared(ladder);
        for (size_t i = 0; i < rungs.size(); ++i) {
            std::string figures;
            for (const Figure& one : rungs[i].figures)
                figures += one.name + " " + std::to_string(one.value) + "  ";
            printf("%-16s %-22s error %.4g bound %.4g mean %.3g p99 %.3g max %.3g bias %.3g nf %.3g  %s  %s B %.3g\n", ladder.name.c_str(), rungs[i].rung.name.c_str(),
                   rungs[i].deviation.error, rungs[i].rung.bound, rungs[i].deviation.mean, rungs[i].deviation.p99, rungs[i].deviation.largest, rungs[i].deviation.bias,
                   rungs[i].deviation.non_finite, rungs[i].worst_input.c_str(), figures.c_str(), rungs[i].bytes_per_pixel);
            CAPTURE(ladder.name, rungs[i].rung.name, rungs[i].worst_input);
            CHECK(rungs[i].deviation.error <= rungs[i].rung.bound);
            if (!rungs[i].rung.no_worse_than.empty())
                CHECK(rungs[i].deviation.error <= rung_called(rungs, rungs[i].rung.no_worse_than).deviation.error);
        }
    }
}
