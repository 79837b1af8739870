// Measures ladders one after another.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tool/accuracy/judge.hpp"

namespace passgraph::accuracy {

struct RunOptions {
    Extent extent{1280, 720};
    TimingOptions timing{};
};

/// Where a run is, for people.
struct Moment {
    std::string text;          ///< "blur: round 3 of 25"
    double seconds_left = 0.0; ///< from what steps took so far
    bool is_new_ladder = false;
};

/// Shows where the run is; false ends it.
using Watch = std::function<bool(const Moment&)>;

struct Measurements {
    std::vector<MeasuredLadder> ladders{}; ///< at least one whole round each
    bool is_interrupted = false;
    std::string renderer{}; ///< GL_RENDERER and GL_VERSION
};

/// Draws every rung, compares it with the truth, and times the rungs of a ladder in turns, the default one twice.
///
/// Errors   of a rung that no longer fits its passes, or of the device. An interruption is none: what is measured is kept.
Result<Measurements> run_ladders(const std::vector<const Ladder*>& ladders, const RunOptions& options, const PassLibrary& library,
                                 GlLoader loader, const Watch& watch);

/// One rung compared with its ladder's truth, untimed.
struct Compared {
    MeasuredRung rung;
    Subject subject;
};
Result<Compared> compare_rung(const Ladder& ladder, const Rung& rung, const Inputs& inputs, const Truth& truth,
                              const PassLibrary& library, GlLoader loader);

} // namespace passgraph::accuracy
