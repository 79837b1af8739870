// The textual half of reading a pass file: its JSON header, its includes, the names it puts at global scope.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include <passgraph/core/declaration.hpp>
#include <passgraph/core/error.hpp>

namespace passgraph {

/// Gives the text of `#include "name"`, with the path it was found at; nullopt when there is none.
struct IncludedFile {
    std::string path;
    std::string text;
};
using IncludeFinder = std::function<std::optional<IncludedFile>(std::string_view name)>;

/// Reads header, includes and names of a pass; no GLSL compiler is asked, so `Access` stays at its safest value.
///
/// Errors   header_missing, json_*, unknown_field, wrong_type, field_missing, unknown_signal, unknown_item, reserved_name,
///          duplicate_name, param_out_of_range (a default outside its range), identity_mismatch, black_mismatch,
///          skip_mismatch, unknown_input, unknown_output, contract_contradicts_signal, unknown_law, forbidden_builtin,
///          include_missing, include_cycle.
Result<PassDeclaration> read_pass_header(std::string_view text, const std::string& file, const std::string& family,
                                         const IncludeFinder& find_include);

/// Sets the access class of each input from what `derived_to_json` wrote. Errors: json_*, wrong_type.
Result<void> apply_derived(PassDeclaration& pass, std::string_view json);
/// The access classes of a pass as JSON, so that a build can bake them.
std::string derived_to_json(const PassDeclaration& pass);

/// Why `name` cannot name a port, parameter or helper; "" when it can.
std::string why_reserved(std::string_view name);

} // namespace passgraph
