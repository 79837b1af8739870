// The driver's compile messages as located errors.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <passgraph/core/error.hpp>

namespace passgraph::gl {

/// How far apart `folded_source_numbers` puts the lines of two sources.
inline constexpr int kSourceStride = 1 << 16;

/// The same program with every `#line LINE SOURCE` as `#line (LINE + SOURCE * kSourceStride)`.
///
/// Mesa's GLSL compiler reports source 0 for every error that is not one of syntax, so the source's number has to
/// travel in the line's.
std::string folded_source_numbers(std::string_view glsl);

/// One error per line that the log complains about (what follows on a line is mostly a consequence); the log's line
/// numbers were folded. The whole log as one error when its form is unknown.
///
/// Forms    Mesa `0:12(5): error: text`, NVIDIA `0(12) : error C1: text`, AMD and Apple `ERROR: 0:12: text`.
Errors shader_errors(std::string_view log, std::string_view subject, const std::vector<std::string>& sources);

} // namespace passgraph::gl
