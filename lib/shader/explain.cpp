// Hints for what glslang says.
#include "shader/explain.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "passgraph/core/glsl_interface.hpp"

namespace passgraph::shader {
namespace {

void add_globals(const GlslText& text, std::vector<std::string>& names)
{
    names.insert(names.end(), text.globals.begin(), text.globals.end());
    for (const auto& include : text.includes)
        add_globals(*include, names);
}

/// The name an author knows: those of common files carry a prefix, c3_name, in the text that is checked.
std::string plain_name(const std::string& name, const GlslText& body)
{
    const size_t end = name.find_first_not_of("0123456789", 1);
    if (!name.starts_with('c') || end == std::string::npos || end == 1 || name[end] != '_')
        return name;
    std::vector<std::string> known;
    add_globals(body, known);
    const std::string plain = name.substr(end + 1);
    return std::find(known.begin(), known.end(), plain) == known.end() ? name : plain;
}

} // namespace

void explain(Error& error, const PassDeclaration& pass)
{
    if (!pass.skip_when.empty() && error.where.file == pass.file && error.where.line == pass.skip_where.line)
        error.hint = "\"when\" is a GLSL condition of inputs called at uv, of parameters and of what the body defines";
    if (!error.message.starts_with('\''))
        return;
    const std::string renamed = error.message.substr(1, error.message.find('\'', 1) - 1);
    const std::string name = plain_name(renamed, pass.body);
    error.message.replace(1, renamed.size(), name);
    const bool is_unknown_call = error.message.find("no matching overloaded function") != std::string::npos;
    const bool is_unknown_name = error.message.find("undeclared identifier") != std::string::npos;
    if (!is_unknown_call && !is_unknown_name)
        return;
    for (const ReadRow& row : kReads) {
        const std::string read(row.name);
        const auto& names = glsl::accessor_names(read);
        if (std::find(names.begin(), names.end(), name) != names.end()) {
            error.hint = fmt::format("add \"{}\" to \"reads\"", read);
            return;
        }
    }
    std::vector<std::string> globals;
    add_globals(pass.body, globals);
    if (is_unknown_call && std::find(globals.begin(), globals.end(), name) == globals.end() &&
        pass.find_input(name) < 0) {
        error.code = "undeclared_input";
        error.message = fmt::format("`{}` is called, but no input or function has that name", name);
        std::vector<std::string> known = globals;
        for (const InputPort& port : pass.inputs)
            known.push_back(port.name);
        const std::string near = closest(name, known);
        error.hint = near.empty() ? fmt::format("declare it: \"inputs\": {{ \"{}\": \"radiance\" }}", name)
                                  : fmt::format("did you mean `{}`?", near);
    } else if (is_unknown_name) {
        error.hint = "parameters are declared in the header's \"params\"";
    } else {
        error.hint = fmt::format("`{}` takes other arguments: inputs are called with one vec2", name);
    }
}

} // namespace passgraph::shader
