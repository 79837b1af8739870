// What may be said of measurements: ratios, fronts, recommendations, and nothing below the noise.
#pragma once

#include <string>
#include <vector>

#include "tool/accuracy/ladder.hpp"
#include "tool/accuracy/statistics.hpp"
#include "tool/accuracy/timing.hpp"

namespace passgraph::accuracy {

/// All that is known of a rung.
struct MeasuredRung {
    Rung rung;
    Deviation deviation{};
    std::vector<Figure> figures{};
    std::string worst_input{};
    double bytes_per_pixel = 0.0;
    Estimate ms{};
    Estimate to_cheapest{};       ///< ratio of times, round by round
    bool is_ratio_claimed = false; ///< the ratio differs from 1 by more than the noise
    bool is_within_bound = true;
    std::string dominated_by{}; ///< a rung that is faster beyond the noise and no less exact; "": none
    std::string as_fast_as{};   ///< a more exact rung from which its time cannot be told apart; "": none
    Picture crop{};             ///< a part of the result, as colors of a display
    std::vector<double> differences{}; ///< signed, of that part's texels; NaN where the result is not finite
};

struct MeasuredLadder {
    const Ladder* ladder = nullptr;
    std::vector<MeasuredRung> rungs{};
    int rounds = 0;
    double noise_floor = 0.0; ///< times of one and the same rung differed by this share
    double map_limit = 0.0;   ///< the largest of all differences shown
    Picture truth_crop{};
};

// Where two runs of one thing differ by more, the machine is too noisy for most claims.
inline constexpr double kNoisy = 0.10;

/// Fills in times, ratios and verdicts. `samples` are those of the rungs, then those of the default rung's twin.
void judge(MeasuredLadder& ladder, const Samples& samples);

/// True when `a` takes less time than `b` by more than the noise: all of their ratio's interval lies beyond it.
bool is_faster(const std::vector<double>& a, const std::vector<double>& b, double noise_floor);

/// The most exact rung of at most so many milliseconds, or nullptr.
const MeasuredRung* best_within(const MeasuredLadder& ladder, double ms);

/// The rung the ladder is used with.
const MeasuredRung& default_rung(const MeasuredLadder& ladder);

} // namespace passgraph::accuracy
