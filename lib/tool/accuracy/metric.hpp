// How far a result is from the truth.
#pragma once

#include <array>
#include <string>

#include <passgraph/core/picture.hpp>

namespace passgraph::accuracy {

struct Truth;

/// The distance of one texel's value from the true one.
enum class Distance {
    angle,    ///< degrees between two directions
    relative, ///< length of the difference over the length of the truth
    absolute, ///< largest difference of a component
    is_wrong, ///< 1 when off by more than `tolerance` of the truth plus 1e-3, or not finite; else 0
};

/// Which texel stands for all.
enum class Summary { mean, p99, largest };

struct Metric {
    std::string name; ///< "angle to the true normal, largest"
    std::string unit; ///< "degrees"; "" for a ratio
    Distance distance = Distance::absolute;
    Summary summary = Summary::largest;
    double tolerance = 0.0; ///< of is_wrong
    bool is_per_component = false; ///< relative: each component by itself, the worst of them
    double smallest = 1e-30;       ///< relative: true values below it are measured against it
};

/// A result against the truth. Statistics leave out texels that are not finite; those are counted apart.
struct Deviation {
    double error = 0.0; ///< by the metric's summary
    double mean = 0.0;
    double p99 = 0.0;
    double largest = 0.0;
    double bias = 0.0;       ///< mean of the signed differences
    double non_finite = 0.0; ///< share of the texels
    std::array<int, 2> worst{}; ///< texel of the largest, or of the first that is not finite
};

/// Shape    `result` has the truth's extent and at least its components.
/// Cost     one pass and a selection.
Deviation compare(const Metric& metric, const Truth& truth, const Picture& result);

/// The signed difference that a map shows of a texel: the component furthest off, over the truth when relative; NaN when
/// it is not finite.
double signed_difference(const Metric& metric, const Truth& truth, const Picture& result, int x, int y);

} // namespace passgraph::accuracy
