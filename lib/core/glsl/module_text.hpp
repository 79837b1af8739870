// Emits GLSL texts with their global names renamed, each include once.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "passgraph/core/declaration.hpp"

namespace passgraph::glsl {

/// Collects program text, and which file each `#line` source number stands for.
class ProgramText {
public:
    explicit ProgramText(std::vector<std::string>& sources) : sources_(sources)
    {
        if (sources_.empty())
            sources_.push_back("generated"); // source 0: what no file holds
    }

    void add(std::string_view text) { text_ += text; }
    void add_line(std::string_view line)
    {
        text_ += line;
        text_ += '\n';
    }

    /// Emits the text's includes (once each), then the text with its globals and `renames` replaced.
    void add_module(const GlslText& module, std::string_view prefix,
                    std::vector<std::pair<std::string, std::string>> renames);

    /// Emits a text and what it includes under their own names.
    void add_flat(const GlslText& module);

    std::string take() { return std::move(text_); }

private:
    std::string include_prefix(const GlslText& include);
    int source_number(const std::string& file);

    std::vector<std::string>& sources_;
    std::map<const GlslText*, int> included_;
    std::string text_;
};

} // namespace passgraph::glsl
