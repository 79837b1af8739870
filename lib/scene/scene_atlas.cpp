// The "atlas" of a scene file, and the "cell" of an element: what they say.
#include <cmath>

#include <fmt/format.h>

#include "scene_fields.hpp"

namespace passgraph::scene_file {
namespace {

constexpr int kMost = 16384; // a picture's texels in a direction: a cell has one at least

/// Two whole numbers from `least`; reports what is none. False: absent or wrong.
bool whole_pair(JsonFields& fields, std::string_view key, int least, int& first, int& second, Errors& errors)
{
    float numbers[2];
    if (!fields.numbers(key, 2, numbers))
        return false;
    for (const size_t i : {size_t{0}, size_t{1}}) {
        if (numbers[i] == std::floor(numbers[i]) && numbers[i] >= static_cast<float>(least) && numbers[i] <= kMost)
            continue;
        out_of_range(fields.find(key)->array[i],
                     fmt::format("\"{}\" holds whole numbers from {} to {}, not {}", key, least, kMost, numbers[i]),
                     errors);
        return false;
    }
    first = static_cast<int>(numbers[0]);
    second = static_cast<int>(numbers[1]);
    return true;
}

Wrap read_wrap(const Json& value, Errors& errors)
{
    if (value.string == "mirror")
        return Wrap::mirror;
    if (value.string == "clamp")
        return Wrap::clamp;
    if (value.string != "repeat") {
        out_of_range(value, fmt::format("element: \"wrap\" is \"{}\"", value.string), errors,
                     suggest(value.string, {"repeat", "mirror", "clamp"}, "wrap modes"));
    }
    return Wrap::repeat;
}

} // namespace

AtlasEntry read_atlas(const Json& json, Errors& errors)
{
    JsonFields fields(json, "atlas", errors);
    AtlasEntry atlas;
    atlas.albedo = read_file_name(fields, "albedo", errors);
    if (fields.find("material"))
        atlas.material = read_file_name(fields, "material", errors);
    if (fields.find("emissive"))
        atlas.emissive = read_file_name(fields, "emissive", errors);
    atlas.emissive_strength = number_in(fields, "emissive_strength", 1.0f, {0.0, kLargestColor}, errors);
    if (const Json* cells = fields.require("cells")) {
        atlas.cells_where = cells->where;
        whole_pair(fields, "cells", 1, atlas.columns, atlas.rows, errors);
    }
    fields.finish();
    return atlas;
}

std::optional<CellEntry> read_cell(JsonFields& fields, Errors& errors)
{
    const Json* value = fields.find("cell");
    const Json* wrap = fields.find("wrap", Json::Kind::string);
    if (!value) {
        if (wrap) {
            out_of_range(*wrap, "element: \"wrap\" is for one with a \"cell\"", errors,
                         "without a cell the model's own textures say how they wrap");
        }
        return std::nullopt;
    }
    CellEntry cell;
    cell.where = value->where;
    if (wrap)
        cell.wrap = read_wrap(*wrap, errors);
    if (!whole_pair(fields, "cell", 0, cell.column, cell.row, errors))
        return std::nullopt;
    return cell;
}

void check_cells(Entries& entries, Errors& errors)
{
    const auto report = [&](const ElementEntry& element) {
        const auto& [column, row, wrap, where] = *element.cell;
        if (!entries.atlas) {
            errors.push_back({"field_missing",
                              fmt::format("`{}` shows a cell, but the scene has no \"atlas\"", element.name),
                              "add \"atlas\": { \"albedo\": a picture, \"cells\": [columns, rows] }", where});
            return true;
        }
        const auto& [columns, rows] = std::pair(entries.atlas->columns, entries.atlas->rows);
        if (columns == 0 || (column < columns && row < rows))
            return columns == 0;
        errors.push_back({"value_out_of_range",
                          fmt::format("`{}` shows the cell [{}, {}] of an atlas of {} x {}", element.name, column, row,
                                      columns, rows),
                          fmt::format("columns count from 0 to {}, rows from 0, the top one, to {}", columns - 1,
                                      rows - 1),
                          where});
        return true;
    };
    for (ElementEntry& element : entries.elements)
        if (element.cell && report(element))
            element.cell.reset();
}

} // namespace passgraph::scene_file
