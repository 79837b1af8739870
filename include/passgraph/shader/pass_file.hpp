// Pass files: read, checked with glslang, and analysed for how they read their inputs.
#pragma once

#include <string>
#include <vector>

#include <passgraph/core/error.hpp>
#include <passgraph/core/pass_library.hpp>
#include <passgraph/shader/pass_file_cache.hpp>

namespace passgraph {

/// Reads a pass from the text of a .glsl file.
///
/// `common_folders` are searched in order for `#include "NAME"`.
/// Errors   every mistake at once, each with file, line and hint: json_*, unknown_field, wrong_type, field_missing,
///          unknown_signal, reserved_name, duplicate_name, entry_missing, entry_signature, undeclared_input, input_unused,
///          output_unwritten, forbidden_builtin, include_missing, glsl_error.
/// Cost     about 5 ms; the first call of a process 80 ms more (glslang's own tables).
Result<PassPtr> read_pass(const std::string& text, const std::string& file, const std::string& family,
                          const std::vector<std::string>& common_folders);

/// Reads a pass file; `common/` beside it or one folder up is searched for includes, then `fallback_common`.
Result<PassPtr> load_pass_file(const std::string& path, const std::string& fallback_common = "");

/// Adds every pass of a folder and its subfolders (except `common`): NAME.glsl, then NAME.graph.json composites.
/// With a cache, files that did not change since it last saw them are not read again.
/// Errors   all mistakes of all files; passes without mistakes are added all the same.
Result<void> load_pass_folder(const std::string& folder, PassLibrary& library, const std::string& fallback_common = "",
                              PassFileCache* cache = nullptr);

} // namespace passgraph
