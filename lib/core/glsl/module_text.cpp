// Emits GLSL texts with their global names renamed, each include once.
#include "core/glsl/module_text.hpp"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

#include "core/pass/glsl_scan.hpp"

namespace passgraph::glsl {
namespace {

using Renames = std::vector<std::pair<std::string, std::string>>;

const std::string* find_rename(const Renames& renames, std::string_view name)
{
    for (const auto& [from, to] : renames)
        if (from == name)
            return &to;
    return nullptr;
}

/// The text with identifiers replaced where they stand for globals: not behind a dot, and not where a struct names a member.
/// Lines keep their number.
std::string with_renames(const std::string& text, const Renames& renames)
{
    const std::vector<GlslToken> tokens = scan_glsl(text, 1, 1);
    std::string result;
    const char* copied = text.data();
    bool is_in_struct = false;
    for (size_t i = 0; i < tokens.size(); ++i) {
        const std::string_view word = tokens[i].text;
        const std::string_view next = i + 1 < tokens.size() ? tokens[i + 1].text : "";
        is_in_struct = is_in_struct ? word != "}" : word == "{" && i > 1 && tokens[i - 2].text == "struct";
        const bool is_member =
            (i > 0 && tokens[i - 1].text == ".") || (is_in_struct && (next == ";" || next == "," || next == "["));
        const std::string* replacement = tokens[i].is_identifier && !is_member ? find_rename(renames, word) : nullptr;
        if (!replacement)
            continue;
        result.append(copied, word.data());
        result += *replacement;
        copied = word.data() + word.size();
    }
    return result.append(copied, text.data() + text.size());
}

bool is_number(const std::string& text)
{
    return !text.empty() && std::isdigit(static_cast<unsigned char>(text.front()));
}

} // namespace

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

void ProgramText::add_module(const GlslText& module, std::string_view prefix,
                             std::vector<std::pair<std::string, std::string>> renames)
{
    for (const auto& include : module.includes) {
        const std::string include_names = include_prefix(*include);
        for (const std::string& global : include->globals)
            renames.emplace_back(global, include_names + global);
    }
    for (const std::string& global : module.globals)
        renames.emplace_back(global, std::string(prefix) + global);
    // Selections are numbers that `#if` compares, so they are macros. Other names are replaced in the text, where a dot tells
    // a struct's member from a port of the same name; a text with macros of its own needs macros for them too.
    Renames macros;
    Renames names;
    for (auto& rename : renames)
        (is_number(rename.second) || !module.macros.empty() ? macros : names).push_back(std::move(rename));
    for (const auto& [name, replacement] : macros)
        add_line(fmt::format("#define {} {}", name, replacement));
    add_line(fmt::format("#line {} {}", module.first_line, source_number(module.file)));
    add(with_renames(module.text, names));
    if (!module.text.ends_with('\n'))
        add_line("");
    add_line("#line 1 0");
    for (const auto& [name, replacement] : macros)
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
