// Parts of results as pictures, and their differences from the truth in color.
#pragma once

#include "tool/accuracy/judge.hpp"

namespace passgraph::accuracy {

/// The part of the truth that the ladder shows, as colors of a display. Shape: the ladder's crop or what there is of it.
Picture truth_crop(const Ladder& ladder, const Truth& truth);
/// The same part of a result; texels that are not finite are magenta.
Picture result_crop(const Ladder& ladder, const Truth& truth, const Picture& result);
/// Signed differences of that part's texels, row by row.
std::vector<double> crop_differences(const Ladder& ladder, const Truth& truth, const Picture& result);

// Maps show differences from the limit down to this share of it; less is white.
inline constexpr double kMapDecades = 5.0;

/// Differences in color: red above the truth, blue below, white none, magenta not finite; logarithmic, full at `limit`.
Picture difference_map(const std::vector<double>& differences, Extent extent, double limit);
/// The color of a difference in such a map.
std::array<float, 3> map_color(double difference, double limit);

} // namespace passgraph::accuracy
