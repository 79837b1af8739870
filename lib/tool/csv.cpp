// Reads and writes tables of numbers.
#include "tool/csv.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string_view>

#include <fmt/format.h>
#include <unistd.h>

#include <passgraph/core/pass_header.hpp>

namespace passgraph::tool {
namespace {

struct Cell {
    std::string_view text;
    Location where;
};

std::vector<Cell> cells_of(std::string_view line, const std::string& file, int number)
{
    std::vector<Cell> cells;
    for (size_t start = 0;;) {
        const size_t end = std::min(line.find(',', start), line.size());
        std::string_view text = line.substr(start, end - start);
        const size_t first = std::min(text.find_first_not_of(" \t"), text.size());
        text.remove_prefix(first);
        while (!text.empty() && (text.back() == ' ' || text.back() == '\t'))
            text.remove_suffix(1);
        cells.push_back({text, {file, number, static_cast<int>(start + first) + 1}});
        if (end == line.size())
            return cells;
        start = end + 1;
    }
}

std::optional<float> cell_number(std::string_view text)
{
    if (text.starts_with('+') && text.size() > 1 && text[1] != '-' && text[1] != '+')
        text.remove_prefix(1);
    float number = 0.0f;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (end != text.data() + text.size() || failure == std::errc::invalid_argument)
        return std::nullopt;
    if (failure == std::errc::result_out_of_range) // too large or too small: infinity or zero, by the rules of rounding
        return std::strtof(std::string(text).c_str(), nullptr);
    return number;
}

/// Why a column cannot be a variable of the expression; "" when it can. Some names a pass may not use are the most
/// natural ones of a column: `x` only looks like a swizzle.
std::string why_no_column(std::string_view name)
{
    const std::string why = why_reserved(name);
    return why == why_reserved("x") ? "" : why;
}

void read_header(const std::vector<Cell>& cells, CsvTable& table, Errors& errors)
{
    for (const Cell& cell : cells) {
        const std::string name(cell.text);
        if (const std::string why = why_no_column(name); !why.empty())
            errors.push_back({"csv_column", fmt::format("`{}` cannot be a column: {}", name, why),
                              "columns are float variables of the expression: rename it", cell.where});
        else if (std::find(table.columns.begin(), table.columns.end(), name) != table.columns.end())
            errors.push_back({"csv_column", fmt::format("the column `{}` is there twice", name), "rename one of the two", cell.where});
        table.columns.push_back(name);
    }
}

void read_row(const std::vector<Cell>& cells, CsvTable& table, Errors& errors)
{
    if (cells.size() != table.columns.size())
        errors.push_back({"csv_row", fmt::format("this row has {} cells, the header {}", cells.size(), table.columns.size()), "",
                          cells.back().where});
    std::vector<float> row;
    for (const Cell& cell : cells) {
        const std::optional<float> number = cell_number(cell.text);
        if (!number)
            errors.push_back({"csv_cell",
                              cell.text.empty() ? std::string("this cell is empty") : fmt::format("`{}` is not a number", cell.text),
                              "cells are decimal numbers, nan, inf or -inf", cell.where});
        row.push_back(number.value_or(0.0f));
    }
    table.rows.push_back(std::move(row));
}

std::string number_text(float number)
{
    return std::isnan(number) ? "nan" : fmt::format("{:.9g}", number); // whatever a NaN's sign
}

Result<void> unwritable(const std::string& path)
{
    return fail({.code = "file_unwritable",
                 .message = fmt::format("`{}` cannot be written", path),
                 .hint = "is there such a folder, and may you write to it?"});
}

bool write_plain(const std::string& path, const std::string& text)
{
    std::ofstream file(path, std::ios::binary);
    file << text;
    file.close();
    return !file.fail();
}

} // namespace

Result<CsvTable> read_csv(const std::string& text, const std::string& file)
{
    CsvTable table;
    Errors errors;
    std::string_view rest = text;
    if (rest.starts_with("\xEF\xBB\xBF")) // a spreadsheet's byte order mark
        rest.remove_prefix(3);
    bool has_header = false;
    for (int number = 1; !rest.empty(); ++number) {
        const size_t end = std::min(rest.find('\n'), rest.size());
        std::string_view line = rest.substr(0, end);
        rest.remove_prefix(std::min(end + 1, rest.size()));
        if (line.ends_with('\r'))
            line.remove_suffix(1);
        if (line.find_first_not_of(" \t") == std::string_view::npos)
            continue;
        const std::vector<Cell> cells = cells_of(line, file, number);
        if (has_header)
            read_row(cells, table, errors);
        else
            read_header(cells, table, errors);
        has_header = true;
    }
    if (!has_header)
        errors.push_back({"csv_empty", "the table is empty", "its first line names the columns", {file, 1, 1}});
    if (!errors.empty())
        return tl::unexpected(std::move(errors));
    return table;
}

std::string csv_text(const CsvTable& table, const std::vector<std::string>& more_columns,
                     const std::vector<std::vector<float>>& more)
{
    std::string text;
    const auto add = [&](const std::string& cell, bool is_last) { text += cell + (is_last ? "\n" : ","); };
    for (const std::string& column : table.columns)
        add(column, false);
    for (size_t i = 0; i < more_columns.size(); ++i)
        add(more_columns[i], i + 1 == more_columns.size());
    for (size_t row = 0; row < table.rows.size(); ++row) {
        for (const float number : table.rows[row])
            add(number_text(number), false);
        for (size_t i = 0; i < more[row].size(); ++i)
            add(number_text(more[row][i]), i + 1 == more[row].size());
    }
    return text;
}

Result<void> write_text_file(const std::string& path, const std::string& text)
{
    std::error_code failed;
    const bool is_special = std::filesystem::exists(path, failed) && !std::filesystem::is_regular_file(path, failed);
    if (is_special)
        return write_plain(path, text) ? Result<void>() : unwritable(path);
    const std::string partial = fmt::format("{}.{}.partial", path, ::getpid());
    if (write_plain(partial, text)) {
        std::filesystem::rename(partial, path, failed);
        if (!failed)
            return {};
    }
    std::filesystem::remove(partial, failed);
    return unwritable(path);
}

} // namespace passgraph::tool
