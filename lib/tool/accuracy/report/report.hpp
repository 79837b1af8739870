// What a run leaves in its folder.
#pragma once

#include <string>
#include <vector>

#include <passgraph/core/error.hpp>

#include "tool/accuracy/report/conditions.hpp"
#include "tool/accuracy/run.hpp"

namespace passgraph::accuracy {

/// The whole run as a JSON object; its schema is schemas/accuracy.schema.json.
std::string report_json(const Measurements& measurements, const Conditions& conditions);
/// One row per rung, the same numbers.
std::string report_csv(const Measurements& measurements);
/// One page that needs no other file: charts, tables, crops beside maps of the differences, conditions.
std::string report_html(const Measurements& measurements, const Conditions& conditions);

/// Writes accuracy.json, accuracy.csv, index.html and the charts as SVG and PNG into the folder, which is made if it is not there.
/// Errors   file_unwritable.
Result<void> write_report(const std::string& folder, const Measurements& measurements, const Conditions& conditions);

// What the page is made of.

/// "0.00352", "1.8e-05", "0": three digits.
std::string short_number(double value);
/// "0.0035 degrees", "1.2 %", "0 (exact)": an error with its unit.
std::string error_text(const Metric& metric, double error);
/// The section of one ladder.
std::string ladder_html(const MeasuredLadder& ladder);
/// Ladder by ladder, the most exact rung for a few budgets, and the default.
std::string budgets_html(const Measurements& measurements);
/// Renderer, threads, size, rounds, noise: what the numbers may be used for.
std::string conditions_html(const Measurements& measurements, const Conditions& conditions);
/// A picture as `data:image/png;base64,...`.
std::string data_uri(const Picture& picture);

} // namespace passgraph::accuracy
