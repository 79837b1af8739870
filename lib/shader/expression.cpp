// Makes the functions of a file stand before a GLSL expression, and finds the expression's type.
#include "passgraph/shader/expression.hpp"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "core/glsl/assemble.hpp"
#include "core/glsl/module_text.hpp"
#include "passgraph/core/json.hpp"
#include "passgraph/core/pass_header.hpp"
#include "passgraph/shader/pass_file.hpp"
#include "shader/glslang_parse.hpp"

namespace passgraph {
namespace {

/// A common file is read as a pass whose body includes it: one reader, one set of rules.
std::string wrapper_of(const std::string& name)
{
    return fmt::format("/*{{ \"pass\": \"scope\", \"outputs\": {{ \"value\": \"exposure\" }} }}*/\n#include "
                       "\"{}\"\nfloat scope(vec2 uv) {{ return 0.0; }}\n",
                       name);
}

std::string without_main(std::string text)
{
    const std::string ending = "void main() {}\n";
    const size_t at = text.rfind(ending);
    if (at != std::string::npos)
        text.erase(at, ending.size());
    const std::string version = "#version 330 core\n";
    if (text.starts_with(version))
        text.erase(0, version.size());
    return text;
}

} // namespace

Result<ExpressionScope> load_expression_scope(const std::string& path, const std::string& fallback_common)
{
    const auto text = read_text_file(path);
    if (!text)
        return tl::unexpected(text.error());
    const size_t start = text->find_first_not_of(" \t\r\n");
    const bool is_pass = start != std::string::npos && text->compare(start, 3, "/*{") == 0;
    const std::filesystem::path file(path);
    const std::string folder = file.has_parent_path() ? file.parent_path().string() : ".";
    auto pass = is_pass ? load_pass_file(path, fallback_common)
                        : read_pass(wrapper_of(file.filename().string()), path, "", {folder, fallback_common});
    if (!pass)
        return tl::unexpected(pass.error());

    ExpressionScope scope;
    std::vector<int> selections;
    for (const Selection& selection : (*pass)->selections)
        selections.push_back(selection.default_item);
    PassDeclaration folded = **pass; // there is no host to set uniforms: every parameter is its default
    for (Param& param : folded.params)
        param.is_static = true;
    folded.reads = {};
    if ((*pass)->reads != Reads{})
        return fail({"scope_needs_host",
                     fmt::format("`{}` reads what only a frame can give", path),
                     "include a common file instead",
                     {path, 1, 1}});
    if (!is_pass) { // the file's own names, not renamed
        glsl::ProgramText program(scope.sources);
        program.add_flat(*folded.body.includes.front());
        scope.declarations = program.take();
        return scope;
    }
    scope.declarations = without_main(glsl::standalone_text(folded, selections, scope.sources));
    return scope;
}

Result<int> expression_components(const ExpressionScope& scope, const std::string& expression,
                                  const std::vector<std::string>& columns)
{
    std::string head = "#version 330 core\n" + scope.declarations + "#line 1 0\nvoid main()\n{\n";
    for (const std::string& column : columns)
        head += fmt::format("    float {} = 0.0;\n", column);
    Errors first;
    const std::vector<std::string> tries = {"bool passgraph_value = {};", "float passgraph_value = {};",
                                            "vec2 passgraph_value = {};", "vec3 passgraph_value = {};",
                                            "vec4 passgraph_value = {};"};
    // Only integers become floats by themselves, so one type fits; a boolean is a number, too.
    for (int components = 4; components >= 0; --components) {
        const std::string statement = fmt::format(fmt::runtime(tries[static_cast<size_t>(components)]), expression);
        const auto parsed = shader::ParsedShader::parse(head + "#line 1 0\n" + statement + "\n}\n", scope.sources);
        if (parsed)
            return std::max(components, 1);
        first = parsed.error();
    }
    for (Error& error : first)
        if (error.where.file == "generated")
            error.where = {"expression", 1, 0};
    return tl::unexpected(std::move(first));
}

} // namespace passgraph
