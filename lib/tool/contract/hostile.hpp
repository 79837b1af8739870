// GLSL builtins that do the worst the language allows.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace passgraph::tool::contract {

/// The builtins that have a hostile version, those that make NaN before those that hide it: where GLSL leaves a result undefined, that version returns NaN.
///
/// Drivers differ there, and a forgiving one hides mistakes: llvmpipe's max(NaN, 0) is 0, so that a pass which relies on it
/// looks right until it meets a GPU.
const std::vector<std::string>& hostile_builtins();
/// When a builtin's result is undefined: "its base is negative, or 0 with an exponent of 0 or less".
std::string_view undefined_when(std::string_view builtin);

/// A complete GLSL 3.30 shader whose calls of these builtins reach their hostile versions.
///
/// `forgiving` is one of them, or none: it returns 0 where its result is undefined. A shader that only then gives finite
/// values has its fault there.
std::string with_hostile(const std::string& shader, const std::vector<std::string>& builtins, std::string_view forgiving = "");

/// The shader with `min`, `max` or `clamp` replaced by one of its arguments, counted from 0. It may not compile.
std::string with_bound_removed(const std::string& shader, std::string_view builtin, int kept_argument);

} // namespace passgraph::tool::contract
