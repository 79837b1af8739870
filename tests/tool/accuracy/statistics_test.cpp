// Medians, intervals and what may be claimed of them.
#include "support/catch.hpp"
#include "tool/accuracy/judge.hpp"

using namespace passgraph::accuracy;

namespace {

/// Rounds of about `ms`, off by up to `noise` of it, the same for a seed.
std::vector<double> rounds_of(double ms, double noise, unsigned seed)
{
    std::vector<double> rounds;
    for (unsigned i = 0; i < 25; ++i) {
        seed = seed * 1664525u + 1013904223u;
        rounds.push_back(ms * (1.0 + noise * (static_cast<double>(seed >> 8) / 8388608.0 - 1.0)));
    }
    return rounds;
}

const Ladder& any_ladder()
{
    static const Ladder ladder{.name = "any", .title = "Any", .stage = "", .about = "", .passes = {}};
    return ladder;
}

MeasuredLadder ladder_of(const std::vector<std::pair<std::string, double>>& rungs)
{
    MeasuredLadder ladder{.ladder = &any_ladder()};
    for (const auto& [name, error] : rungs) {
        MeasuredRung rung;
        rung.rung.name = name;
        rung.rung.bound = 1.0;
        rung.deviation.error = error;
        ladder.rungs.push_back(rung);
    }
    ladder.rungs.front().rung.is_default = true;
    return ladder;
}

} // namespace

TEST_CASE("a median is the middle value, or the mean of the two", "[accuracy][statistics]")
{
    CHECK(median({3.0}) == 3.0);
    CHECK(median({5.0, 1.0, 3.0}) == 3.0);
    CHECK(median({4.0, 1.0, 3.0, 2.0}) == 2.5);
}

TEST_CASE("a bootstrap interval holds the median, is the same each time, and narrows with the noise", "[accuracy][statistics]")
{
    const Estimate wide = bootstrap_median(rounds_of(10.0, 0.2, 1), 7);
    const Estimate narrow = bootstrap_median(rounds_of(10.0, 0.01, 1), 7);
    CHECK(wide.interval.low <= wide.median);
    CHECK(wide.median <= wide.interval.high);
    CHECK(bootstrap_median(rounds_of(10.0, 0.2, 1), 7).interval == wide.interval);
    CHECK(narrow.interval.high - narrow.interval.low < 0.2 * (wide.interval.high - wide.interval.low));
    CHECK(bootstrap_median({2.0}, 7).interval == Interval{2.0, 2.0});
}

TEST_CASE("a rung that is slower and no more exact is dominated, by name", "[accuracy][judge]")
{
    MeasuredLadder ladder = ladder_of({{"quick", 0.1}, {"slow", 0.2}, {"exact", 0.001}});
    const auto quick = rounds_of(5.0, 0.02, 1);
    judge(ladder, {quick, rounds_of(9.0, 0.02, 2), rounds_of(12.0, 0.02, 3), quick});
    CHECK(ladder.noise_floor == 0.0);
    CHECK(ladder.rungs[0].dominated_by.empty());
    CHECK(ladder.rungs[1].dominated_by == "quick");
    CHECK(ladder.rungs[2].dominated_by.empty());
    CHECK_FALSE(ladder.rungs[0].is_ratio_claimed);
    CHECK(ladder.rungs[1].is_ratio_claimed);
    CHECK(ladder.rungs[1].to_cheapest.median == Approx(1.8).epsilon(0.05));
}

TEST_CASE("nothing is claimed below the noise of a rung against itself", "[accuracy][judge]")
{
    MeasuredLadder ladder = ladder_of({{"quick", 0.1}, {"slow", 0.2}});
    const auto quick = rounds_of(5.0, 0.02, 1);
    judge(ladder, {quick, rounds_of(6.0, 0.02, 2), rounds_of(6.5, 0.02, 3)}); // its twin was slower still
    CHECK(ladder.noise_floor > 0.2);
    CHECK(ladder.rungs[1].dominated_by.empty());
    CHECK(ladder.rungs[1].as_fast_as == "quick");
    CHECK_FALSE(ladder.rungs[1].is_ratio_claimed);
}

TEST_CASE("a faster rung that breaks more texels dominates nothing", "[accuracy][judge]")
{
    MeasuredLadder ladder = ladder_of({{"safe", 0.2}, {"broken", 0.1}});
    ladder.rungs[1].deviation.non_finite = 0.01;
    const auto safe = rounds_of(9.0, 0.01, 1);
    judge(ladder, {safe, rounds_of(5.0, 0.01, 2), safe});
    CHECK(ladder.rungs[0].dominated_by.empty());
}

TEST_CASE("a budget buys the most exact rung whose interval it holds", "[accuracy][judge]")
{
    MeasuredLadder ladder = ladder_of({{"quick", 0.1}, {"exact", 0.001}});
    const auto quick = rounds_of(2.0, 0.01, 1);
    judge(ladder, {quick, rounds_of(7.0, 0.01, 2), quick});
    CHECK(best_within(ladder, 1.0) == nullptr);
    CHECK(best_within(ladder, 5.0) == &ladder.rungs[0]);
    CHECK(best_within(ladder, 10.0) == &ladder.rungs[1]);
    CHECK(&default_rung(ladder) == &ladder.rungs[0]);
}
