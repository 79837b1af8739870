// The chart of a ladder: time against error, both logarithmic.
#pragma once

#include "tool/accuracy/judge.hpp"
#include "tool/accuracy/report/drawing.hpp"

namespace passgraph::accuracy {

/// Each rung a point with its name and the interval of its time; the front drawn, dominated rungs grey and named so, the
/// default ringed. An error of 0 stands on a line of its own below the scale.
Drawing pareto_chart(const MeasuredLadder& ladder);

} // namespace passgraph::accuracy
