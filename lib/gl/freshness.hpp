// Which steps of a plan must run, because what they would draw is not there yet.
#pragma once

#include <cstdint>
#include <vector>

#include <passgraph/core/plan.hpp>

namespace passgraph::gl {

/// Another value for every pair, and without a pattern.
std::uint64_t mixed(std::uint64_t hash, std::uint64_t value);

/// What a frame's steps depend on beside each other, each as a number that changes when the thing does.
struct Versions {
    std::uint64_t camera = 0;
    std::uint64_t scene = 0;
    std::uint64_t frame = 0;              ///< another each frame
    std::vector<std::uint64_t> imports{}; ///< by import
    std::vector<std::uint64_t> params{};  ///< by step: of its live parameters' values
};

/// Remembers what each slot holds, by a number made of everything that its texels depend on: the steps' texts and values,
/// and what they read. Equal numbers are equal images, in another plan too.
///
/// A step is asked for when an output's slot, or the slot that a running step reads, holds anything else than what the
/// step would draw now; a producer whose image another running step overwrites is asked for again.  O(steps * reads).
class Freshness {
public:
    Freshness() = default;
    explicit Freshness(const Plan& plan);

    /// Which steps must run, in the plan's order. `redraws`: all, but for steps that nothing can change.
    std::vector<bool> stale(const Plan& plan, const Versions& versions, bool redraws);

    /// By query: has it counted the pixels of the image that its step would draw now, or will it in this frame, as the steps
    /// that `stale` asked for run? A query that never counted, or counted another image, decides nothing.
    std::vector<bool> answers(const Plan& plan, const std::vector<bool>& runs, bool counts) const;

    /// The steps that `stale` asked for have run: their slots hold what it wanted, and their queries have counted it if the
    /// frame `counted`.
    void have_run(const Plan& plan, const std::vector<bool>& ran, bool counted);

    /// Nothing is known of any slot.
    void forget();

    /// A slot or query of another plan, and that here which would get the same image.
    struct Carried {
        size_t from = 0;
        size_t to = 0;
    };
    struct CarriedOver {
        std::vector<Carried> slots;
        std::vector<Carried> queries;
    };
    /// The images of a plan that ran which this plan would draw again under these versions, and the queries that counted
    /// them. They count as held here, and no longer there: the textures and queries are to change places.
    CarriedOver carry_over(const Plan& plan, const Versions& versions, Freshness& from);

private:
    void find_wanted(const Plan& plan, const Versions& versions);

    std::vector<std::uint64_t> content_;      ///< by step: of its texts, extents and formats
    std::vector<std::uint64_t> held_;         ///< by slot; 0: unknown
    std::vector<std::uint64_t> counted_;      ///< by query: the version of its step that it counted; 0: none
    std::vector<std::uint64_t> wanted_;       ///< by step, of the last `stale`
    std::vector<std::vector<int>> producers_; ///< by step and read: the step that draws it, -1 for imports
};

} // namespace passgraph::gl
