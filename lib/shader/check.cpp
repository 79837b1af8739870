// Checks a pass's body with glslang, under each of its selections, and derives how it reads its inputs.
#include "shader/check.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/glsl/assemble.hpp"
#include "core/glsl/module_text.hpp"
#include "core/pass/glsl_scan.hpp"
#include "passgraph/core/glsl_interface.hpp"
#include "shader/explain.hpp"
#include "shader/glslang_parse.hpp"
#include "shader/interpreter.hpp"
#include "shader/tree.hpp"
#include "shader/variants.hpp"

namespace passgraph::shader {
namespace {

/// Whether the preprocessor leaves the same text in every program: names are renamed there, and extensions differ.
bool is_same_everywhere(const GlslText& text)
{
    const auto is_own = [&](std::string_view name) {
        return std::find(text.macros.begin(), text.macros.end(), name) != text.macros.end();
    };
    const auto varies = [](std::string_view name) { return name.starts_with("__") || name.starts_with("GL_"); };
    for (const GlslToken& token : scan_glsl(text.text, 1, 1)) {
        const auto words = token.is_directive ? scan_glsl(token.text.substr(1), 1, 1) : std::vector<GlslToken>{token};
        bool asks = false;
        for (const GlslToken& word : words) {
            if (varies(word.text) || (asks && word.is_identifier && !is_own(word.text)))
                return false;
            asks =
                word.text == "ifdef" || word.text == "ifndef" || word.text == "defined" || (asks && word.text == "(");
        }
    }
    return std::all_of(text.includes.begin(), text.includes.end(),
                       [](const auto& include) { return is_same_everywhere(*include); });
}

std::string signature(const PassDeclaration& pass)
{
    if (pass.outputs.size() == 1)
        return fmt::format("{} {}(vec2 uv)", glsl_type(info(pass.outputs.front().signal).components), pass.name);
    std::string text = fmt::format("void {}(vec2 uv", pass.name);
    for (const OutputPort& port : pass.outputs)
        text += fmt::format(", out {} {}", glsl_type(info(port.signal).components), port.name);
    return text + ")";
}

std::string mangled_out(int components) { return components == 1 ? "f1;" : fmt::format("vf{};", components); }

struct Entry {
    std::string mangled;
    std::string text; ///< as an author writes it
    bool has_uv = false;
    std::vector<std::string> outs{}; ///< names, in order; empty: of any name
    bool is_condition = false;       ///< of "skip": generated around the header's text
};

std::vector<Entry> entries_of(const PassDeclaration& pass)
{
    if (pass.kind == PassKind::image) {
        Entry entry{pass.name + "(vf2;", signature(pass), true};
        for (const OutputPort& port : pass.outputs) {
            if (pass.outputs.size() == 1)
                break;
            entry.mangled += mangled_out(info(port.signal).components);
            entry.outs.push_back(port.name);
        }
        if (pass.skip_when.empty())
            return {entry};
        return {entry, {.mangled = std::string(glsl::kSkips) + "(vf2;", .text = {}, .has_uv = true, .outs = {}, .is_condition = true}};
    }
    Entry vertex{
        pass.name + "_vertex(vf3;vf3;vf2;vf3;vf3;vf2;",
        fmt::format(
            "void {}_vertex(vec3 position, vec3 normal, vec2 texcoord, out vec3 placed, out vec3 facing, out vec2 uv)",
            pass.name)};
    Entry surface{pass.name + "_surface(vf3;vf3;vf2;",
                  fmt::format("void {}_surface(vec3 placed, vec3 facing, vec2 uv", pass.name)};
    for (const OutputPort& port : pass.outputs) {
        if (port.signal == Signal::depth)
            continue;
        surface.mangled += mangled_out(info(port.signal).components);
        surface.outs.push_back(port.name);
        surface.text += fmt::format(", out {} {}", glsl_type(info(port.signal).components), port.name);
    }
    surface.text += ")";
    return {vertex, surface};
}

/// glslang's names of functions say neither result, nor which parameters are out, nor their names.
bool has_right_shape(const PassDeclaration& pass, const Entry& entry, const glslang::TIntermAggregate& function)
{
    const bool is_image = pass.kind == PassKind::image;
    const auto& type = function.getType();
    std::vector<std::string> outs;
    for (const glslang::TIntermSymbol* parameter : parameters_of(function)) {
        if (parameter->getQualifier().storage == glslang::EvqInOut)
            return false;
        if (is_out(*parameter))
            outs.emplace_back(parameter->getName().c_str());
    }
    if (is_image && pass.outputs.size() == 1) {
        const bool is_vector = type.getBasicType() == glslang::EbtFloat && !type.isMatrix() && !type.isArray();
        return outs.empty() && is_vector &&
               static_cast<int>(width_of(type)) == info(pass.outputs.front().signal).components;
    }
    return type.getBasicType() == glslang::EbtVoid && (entry.outs.empty() ? outs.size() == 3 : outs == entry.outs);
}

class Check {
public:
    explicit Check(PassDeclaration& pass)
        : pass_(pass), is_used_(pass.inputs.size(), false), access_(pass.inputs.size())
    {
    }

    Result<void> run()
    {
        check_includes();
        // Open selections are one analysis instead of one for each combination of items. Where it finds less, or nothing can
        // stand so, each combination is looked at.
        const auto open = selections_of(pass_, true);
        bool is_complete = stands(open.all.front()) && analyse(open) && !has_unknown_reach();
        if (!is_complete) {
            errors_.clear();
            check_includes();
            is_used_.assign(is_used_.size(), false);
            access_.assign(access_.size(), std::nullopt);
            is_complete = analyse(selections_of(pass_, false));
        }
        if (errors_.empty())
            report_unused();
        if (!errors_.empty())
            return tl::unexpected(std::move(errors_));
        for (size_t i = 0; i < pass_.inputs.size(); ++i)
            if (pass_.inputs[i].over != Over::scene)
                pass_.inputs[i].access =
                    is_complete ? access_[i].value_or(Access{AccessClass::size_only, 0}) : Access{};
        return {};
    }

private:
    bool has_unknown_reach() const
    {
        for (size_t i = 0; i < access_.size(); ++i)
            if (pass_.inputs[i].over == Over::image && access_[i] && access_[i]->kind == AccessClass::gather &&
                access_[i]->radius == Access::kUnknownRadius)
                return true;
        return false;
    }

    bool stands(const std::vector<int>& selections) const
    {
        std::vector<std::string> sources;
        return static_cast<bool>(ParsedShader::parse(glsl::standalone_text(pass_, selections, sources), sources));
    }

    /// True when what was found holds for every setting there is.
    bool analyse(const VariantList<int>& selections)
    {
        const auto statics = statics_of(pass_);
        bool is_complete = selections.is_complete && is_same_everywhere(pass_.body);
        for (const auto& selection : selections.all) {
            // With its static values unknown but in range, a body is analysed for all of them at once. Where it needs
            // constants (an array's size), the ends of their ranges stand for them.
            const bool is_followed = !statics.all.front().empty() && read_live(selection);
            is_complete = is_complete && (is_followed || statics.is_complete);
            for (const auto& values : statics.all)
                if (errors_.size() <= 20)
                    check_variant(selection, values, !is_followed);
        }
        return is_complete;
    }

    /// One mistake is seen under many variants: it is reported once.
    void report(Error error)
    {
        const bool is_known = std::any_of(errors_.begin(), errors_.end(), [&](const Error& other) {
            return other.code == error.code && other.message == error.message && other.where == error.where;
        });
        if (!is_known)
            errors_.push_back(std::move(error));
    }

    /// Common files hold pure functions: they must stand without the pass's inputs and parameters.
    void check_includes()
    {
        if (pass_.body.includes.empty())
            return;
        std::vector<std::string> sources;
        glsl::ProgramText program(sources);
        program.add_line("#version 330 core");
        program.add(glsl::accessors(pass_.reads, pass_.kind));
        GlslText all;
        all.includes = pass_.body.includes;
        program.add_module(all, "", {});
        program.add_line("void main() {}");
        if (const auto parsed = ParsedShader::parse(program.take(), sources); !parsed)
            for (Error error : parsed.error()) {
                if (error.message.find("no matching") != std::string::npos ||
                    error.message.find("undeclared") != std::string::npos)
                    error.hint = "a common file sees no input or parameter: hand it what it needs as an argument";
                report(std::move(error));
            }
    }

    bool read_live(const std::vector<int>& selections)
    {
        PassDeclaration live = pass_;
        for (Param& param : live.params)
            param.is_static = false;
        std::vector<std::string> sources;
        const auto parsed = ParsedShader::parse(glsl::standalone_text(live, selections, sources), sources);
        if (!parsed)
            return false;
        for (const Entry& entry : entries_of(pass_)) {
            Interpreter interpreter(pass_, parsed->root());
            if (!interpreter.has_function(entry.mangled))
                return false;
            const auto result = interpreter.run(entry.mangled, entry.has_uv);
            for (size_t i = 0; i < result.readings.size(); ++i)
                join_reading(i, result.readings[i]);
        }
        return true;
    }

    void check_variant(const std::vector<int>& selections, const std::vector<Value>& statics, bool is_access_due)
    {
        PassDeclaration standing = pass_;
        for (size_t i = 0; i < statics.size(); ++i)
            standing.params[i].default_value = statics[i];
        std::vector<std::string> sources;
        const std::string text = glsl::standalone_text(standing, selections, sources);
        const auto parsed = ParsedShader::parse(text, sources);
        if (!parsed) {
            for (Error error : parsed.error()) {
                explain(error, pass_);
                report(std::move(error));
            }
            return;
        }
        for (const Entry& entry : entries_of(pass_))
            check_entry(entry, parsed->root(), is_access_due);
    }

    /// A pixel is skipped by what it sees itself: reads elsewhere would have the whole pass gather for a condition's sake.
    void check_condition(const Interpreter::Result& result)
    {
        for (size_t i = 0; i < result.readings.size(); ++i)
            if (const Reading& reading = result.readings[i]; reading.near_pixel + reading.computed > 0 || reading.is_unbounded)
                report({"skip_reads_elsewhere", fmt::format("\"when\" reads `{}` at another place than uv", pass_.inputs[i].name),
                        fmt::format("call {}(uv)", pass_.inputs[i].name), pass_.skip_where});
    }

    void check_entry(const Entry& entry, TIntermNode* root, bool is_access_due)
    {
        Interpreter interpreter(pass_, root);
        if (entry.is_condition) {
            const auto result = interpreter.run(entry.mangled, true);
            check_condition(result);
            for (size_t i = 0; is_access_due && i < result.readings.size(); ++i)
                join_reading(i, result.readings[i]);
            return;
        }
        const std::string name = entry.mangled.substr(0, entry.mangled.find('('));
        const auto overloads = interpreter.overloads(name);
        const Location start{pass_.file, pass_.body.first_line, 0};
        if (overloads.empty()) {
            report(
                {"entry_missing", fmt::format("the file has no function `{}`", name), "write: " + entry.text, start});
            return;
        }
        const Location where{pass_.file, interpreter.function(overloads.front())->getLoc().line, 0};
        if (!interpreter.has_function(entry.mangled) ||
            !has_right_shape(pass_, entry, *interpreter.function(entry.mangled))) {
            report({"entry_signature", fmt::format("`{}` has the wrong parameters or result", name),
                    "write: " + entry.text, where});
            return;
        }
        const auto result = interpreter.run(entry.mangled, entry.has_uv);
        for (const std::string& mangled : result.recursive) {
            const std::string called = mangled.substr(0, mangled.find('('));
            report({"glsl_error",
                    fmt::format("`{}` calls itself", called),
                    "GLSL has no recursion: write a loop",
                    {pass_.file, interpreter.function(mangled)->getLoc().line, 0}});
        }
        for (const std::string& output : result.unwritten) {
            report({"output_unwritten",
                    output.empty() ? fmt::format("`{}` does not return a value on every path", name)
                                   : fmt::format("the output `{}` is not assigned on every path", output),
                    output.empty() ? "return a value at its end"
                                   : fmt::format("assign {} before the first branch", output),
                    where});
        }
        for (size_t i = 0; is_access_due && i < result.readings.size(); ++i)
            join_reading(i, result.readings[i]);
    }

    void join_reading(size_t input, const Reading& reading)
    {
        if (!reading.is_used())
            return;
        is_used_[input] = true;
        const Access found = access_of(reading);
        std::optional<Access>& known = access_[input];
        if (!known || known->kind == AccessClass::size_only || found == *known)
            known = found;
        else if (found.kind == AccessClass::size_only)
            return;
        else if (known->kind == AccessClass::warp || found.kind == AccessClass::warp ||
                 known->radius == Access::kUnknownRadius || found.radius == Access::kUnknownRadius)
            known = Access{AccessClass::gather, Access::kUnknownRadius};
        else
            known = Access{AccessClass::gather, std::max(known->radius, found.radius)};
    }

    void report_unused()
    {
        for (size_t i = 0; i < pass_.inputs.size(); ++i) {
            const InputPort& port = pass_.inputs[i];
            const bool gives_size = std::any_of(pass_.outputs.begin(), pass_.outputs.end(),
                                                [&](const OutputPort& o) { return o.size_of == port.name; });
            if (!is_used_[i] && port.over != Over::scene && !gives_size)
                report({"input_unused", fmt::format("the input `{}` is never read", port.name),
                        fmt::format("call {}({}), or remove it", port.name,
                                    port.over == Over::sphere ? "direction, lod" : "uv"),
                        port.where});
        }
    }

    PassDeclaration& pass_;
    Errors errors_;
    std::vector<bool> is_used_;
    std::vector<std::optional<Access>> access_;
};

} // namespace

Result<void> check_and_derive(PassDeclaration& pass) { return Check(pass).run(); }

} // namespace passgraph::shader
