// What draws cost, by the wall clock around glFinish.
#pragma once

#include <functional>
#include <vector>

#include "tool/accuracy/subject.hpp"

namespace passgraph::accuracy {

struct TimingOptions {
    int rounds = 25;
    double sample_ms = 20.0;          ///< a sample draws as often as it needs to last so long
    double seconds_at_most = 1e9;     ///< of the rounds; `fewest_rounds` are taken all the same
    int fewest_rounds = 15;
    std::uint32_t seed = 20170417;
};

/// Milliseconds per draw, by subject, then by round.
using Samples = std::vector<std::vector<double>>;

/// Draws each subject once per round, in an order shuffled anew, so that a machine's drift meets all alike.
///
/// `go_on(samples done, samples in all)` is asked between samples; false ends the run, keeping whole rounds.
/// Errors   gl_error; draws_skipped when the renderer drew less than it was asked to, which would time nothing.
/// Source   interleaving: Google Benchmark's random interleaving.
Result<Samples> measure(std::vector<Subject>& subjects, const TimingOptions& options, const std::function<bool(int, int)>& go_on);

} // namespace passgraph::accuracy
