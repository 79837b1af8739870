// Medians and how sure of them one may be.
#pragma once

#include <cstdint>
#include <vector>

namespace passgraph::accuracy {

struct Interval {
    double low = 0.0;
    double high = 0.0;
    friend bool operator==(const Interval&, const Interval&) = default;
};

/// A median with its 95 % interval.
struct Estimate {
    double median = 0.0;
    Interval interval{};
};

/// Range    at least one value.
double median(std::vector<double> values);

/// The median and its percentile-bootstrap interval, the same for the same values and seed on every machine.
///
/// Range    at least one value; of one value the interval is the value.
/// Cost     500 medians.
/// Source   Efron 1979, "Bootstrap Methods: Another Look at the Jackknife".
Estimate bootstrap_median(const std::vector<double>& values, std::uint32_t seed);

/// Round by round, a / b.
std::vector<double> paired_ratios(const std::vector<double>& a, const std::vector<double>& b);

} // namespace passgraph::accuracy
