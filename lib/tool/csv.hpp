// Tables of binary32 numbers as CSV.
#pragma once

#include <string>
#include <vector>

#include <passgraph/core/error.hpp>

namespace passgraph::tool {

struct CsvTable {
    std::vector<std::string> columns;
    std::vector<std::vector<float>> rows; ///< each as long as `columns`
};

/// Reads a header of GLSL names and rows of numbers, each rounded once to the nearest binary32.
///
/// Range    decimal numbers, `nan`, `inf`, `-inf`; beyond the largest binary32 is infinity.
/// Errors   csv_empty, csv_column (no usable name, or used twice), csv_cell, csv_row (too many or too few cells),
///          each with line and column.
Result<CsvTable> read_csv(const std::string& text, const std::string& file);

/// The table with further columns behind its own, numbers as `%.9g`, which keeps every bit of a finite one.
std::string csv_text(const CsvTable& table, const std::vector<std::string>& more_columns,
                     const std::vector<std::vector<float>>& more);

/// Writes beside the file and renames; what is no regular file (a pipe, a device) is written in place.
/// Errors   file_unwritable.
Result<void> write_text_file(const std::string& path, const std::string& text);

} // namespace passgraph::tool
