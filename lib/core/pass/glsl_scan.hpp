// A light reading of GLSL text: tokens with places, global names, includes. The grammar is glslang's business.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "passgraph/core/error.hpp"

namespace passgraph {

struct GlslToken {
    std::string_view text;
    int line = 0;
    int column = 0;
    bool is_identifier = false;
    bool is_directive = false; ///< a whole line starting with #, without its line end
};

/// Splits GLSL into tokens; comments and blanks are dropped. `line` and `column` are those of the text's first character.
std::vector<GlslToken> scan_glsl(std::string_view text, int line, int column);

/// Functions, constants and structs at global scope, in order of appearance, each once.
std::vector<std::string> global_names(const std::vector<GlslToken>& tokens);

/// The names that `#define` gives.
std::vector<std::string> macro_names(const std::vector<GlslToken>& tokens);

/// Reports what pass files must not hold: gl_*, texture functions, uniforms, own `main` and, in full-screen passes, derivatives
/// and discard. Error: forbidden_builtin.
void report_forbidden(const std::vector<GlslToken>& tokens, const std::string& file, bool is_geometry, Errors& errors);

} // namespace passgraph
