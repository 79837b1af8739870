// Parses GLSL with glslang and keeps the syntax tree; errors come back with the file's own line.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <glslang/Public/ShaderLang.h>

#include "passgraph/core/error.hpp"

class TIntermNode;

namespace passgraph::shader {

/// A parsed fragment shader; its tree lives as long as this.
class ParsedShader {
public:
    /// `sources` gives the file of each `#line` source number; source 0 is generated text.
    /// Errors   glsl_error, with place and message of each.
    static Result<ParsedShader> parse(const std::string& text, const std::vector<std::string>& sources);

    TIntermNode* root() const;

private:
    std::shared_ptr<glslang::TShader> shader_;
};

} // namespace passgraph::shader
