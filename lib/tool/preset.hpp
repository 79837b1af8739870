// Presets: files of values that apply to a graph's settings.
#pragma once

#include <string>
#include <vector>

#include <passgraph/core/graph.hpp>

namespace passgraph::tool {

/// Reads a preset; its form is schemas/preset.schema.json.
/// Errors   file_missing, json_*, unknown_field, wrong_type, field_missing, version_unknown, each with its place.
Result<std::vector<PassArguments::Setting>> read_preset(const std::string& file);

/// The text of a preset with these settings, numbers as short as they read back the same.
std::string preset_text(const std::vector<PassArguments::Setting>& settings);

/// A setting's value as JSON.
std::string value_text(const PassArguments::Setting& setting);

} // namespace passgraph::tool
