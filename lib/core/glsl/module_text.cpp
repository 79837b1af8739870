// Emits GLSL texts with their global names renamed, each include once.
#include "core/glsl/module_text.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace passgraph::glsl {

int ProgramText::source_number(const std::string& file)
{
    const auto found = std::find(sources_.begin(), sources_.end(), file);
    if (found != sources_.end())
        return static_cast<int>(found - sources_.begin());
    sources_.push_back(file);
    return static_cast<int>(sources_.size()) - 1;
}

std::string ProgramText::include_prefix(const GlslText& include)
{
    const auto found = included_.find(&include);
    if (found != included_.end())
        return fmt::format("c{}_", found->second);
    const int number = static_cast<int>(included_.size());
    included_.emplace(&include, number);
    const std::string prefix = fmt::format("c{}_", number);
    add_module(include, prefix, {});
    return prefix;
}

void ProgramText::add_module(const GlslText& module, std::string_view prefix, std::vector<std::pair<std::string, std::string>> renames)
{
    for (const auto& include : module.includes) {
        const std::string include_names = include_prefix(*include);
        for (const std::string& global : include->globals)
            renames.emplace_back(global, include_names + global);
    }
    for (const std::string& global : module.globals)
        renames.emplace_back(global, std::string(prefix) + global);
    for (const auto& [name, replacement] : renames)
        add_line(fmt::format("#define {} {}", name, replacement));
    add_line(fmt::format("#line {} {}", module.first_line, source_number(module.file)));
    add(module.text);
    if (!module.text.ends_with('\n'))
        add_line("");
    add_line("#line 1 0");
    for (const auto& [name, replacement] : renames)
        add_line("#undef " + name);
    for (const std::string& macro : module.macros)
        add_line("#undef " + macro);
}

void ProgramText::add_flat(const GlslText& module)
{
    if (!included_.emplace(&module, 0).second)
        return;
    for (const auto& include : module.includes)
        add_flat(*include);
    add_line(fmt::format("#line {} {}", module.first_line, source_number(module.file)));
    add(module.text);
    add_line("\n#line 1 0");
}

} // namespace passgraph::glsl
