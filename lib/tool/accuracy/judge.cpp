// Ratios, fronts and recommendations.
#include "tool/accuracy/judge.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace passgraph::accuracy {
namespace {

constexpr std::uint32_t kSeed = 4357;

/// How far the ratio of a thing to itself strays from 1: the further end of its interval.
double noise_of(const std::vector<double>& once, const std::vector<double>& again)
{
    const Estimate ratio = bootstrap_median(paired_ratios(once, again), kSeed);
    return std::max(std::abs(ratio.interval.high - 1.0), std::abs(1.0 - ratio.interval.low));
}

void find_dominated(MeasuredLadder& ladder, const Samples& samples)
{
    for (size_t i = 0; i < ladder.rungs.size(); ++i) {
        MeasuredRung& rung = ladder.rungs[i];
        const MeasuredRung* dominator = nullptr;
        const MeasuredRung* equal = nullptr;
        for (size_t other = 0; other < ladder.rungs.size(); ++other) {
            const MeasuredRung& rival = ladder.rungs[other];
            if (other == i || rival.deviation.error > rung.deviation.error || rival.deviation.non_finite > rung.deviation.non_finite)
                continue;
            if (is_faster(samples[other], samples[i], ladder.noise_floor)) {
                if (!dominator || rival.ms.median < dominator->ms.median)
                    dominator = &rival;
            } else if (rival.deviation.error < rung.deviation.error && !is_faster(samples[i], samples[other], ladder.noise_floor)) {
                if (!equal || rival.deviation.error < equal->deviation.error)
                    equal = &rival;
            }
        }
        rung.dominated_by = dominator ? dominator->rung.name : "";
        rung.as_fast_as = equal && !dominator ? equal->rung.name : "";
    }
}

} // namespace

bool is_faster(const std::vector<double>& a, const std::vector<double>& b, double noise_floor)
{
    const Estimate ratio = bootstrap_median(paired_ratios(a, b), kSeed);
    return ratio.interval.high < 1.0 / (1.0 + noise_floor);
}

void judge(MeasuredLadder& ladder, const Samples& samples)
{
    assert(samples.size() == ladder.rungs.size() + 1 && !samples.front().empty());
    ladder.rounds = static_cast<int>(samples.front().size());
    size_t used = 0;
    size_t cheapest = 0;
    for (size_t i = 0; i < ladder.rungs.size(); ++i) {
        ladder.rungs[i].ms = bootstrap_median(samples[i], kSeed);
        used = ladder.rungs[i].rung.is_default ? i : used;
        cheapest = ladder.rungs[i].ms.median < ladder.rungs[cheapest].ms.median ? i : cheapest;
    }
    ladder.noise_floor = noise_of(samples[used], samples.back());
    for (size_t i = 0; i < ladder.rungs.size(); ++i) {
        MeasuredRung& rung = ladder.rungs[i];
        rung.to_cheapest = bootstrap_median(paired_ratios(samples[i], samples[cheapest]), kSeed);
        rung.is_ratio_claimed = is_faster(samples[cheapest], samples[i], ladder.noise_floor);
        rung.is_within_bound = rung.deviation.error <= rung.rung.bound;
    }
    find_dominated(ladder, samples);
}

const MeasuredRung* best_within(const MeasuredLadder& ladder, double ms)
{
    const MeasuredRung* best = nullptr;
    for (const MeasuredRung& rung : ladder.rungs)
        if (rung.ms.interval.high <= ms && (!best || rung.deviation.error < best->deviation.error ||
                                            (rung.deviation.error == best->deviation.error && rung.ms.median < best->ms.median)))
            best = &rung;
    return best;
}

const MeasuredRung& default_rung(const MeasuredLadder& ladder)
{
    for (const MeasuredRung& rung : ladder.rungs)
        if (rung.rung.is_default)
            return rung;
    return ladder.rungs.back();
}

} // namespace passgraph::accuracy
