// Checks a pass's body with glslang, under each of its selections, and derives how it reads its inputs.
#include "shader/check.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/glsl/assemble.hpp"
#include "passgraph/core/glsl_interface.hpp"
#include "shader/glslang_parse.hpp"
#include "shader/interpreter.hpp"
#include "shader/tree.hpp"

namespace passgraph::shader {
namespace {

/// Selections and static values under which a body may differ: each is parsed and analysed.
struct Variant {
    std::vector<int> selections;
    std::vector<Value> statics; ///< as pass.params
};

constexpr size_t kMostVariants = 256;

std::vector<Value> candidate_values(const Param& param)
{
    std::vector<Value> values = {param.default_value};
    if (!param.is_static)
        return values;
    if (param.type == ParamType::bool_)
        return {Value(0.0), Value(1.0)};
    if (param.type == ParamType::enum_) {
        values.clear();
        for (size_t i = 0; i < param.items.size(); ++i)
            values.emplace_back(static_cast<double>(i));
        return values;
    }
    for (const double end : {param.lowest, param.highest})
        if (std::isfinite(end))
            values.emplace_back(end, end, end, end);
    return values;
}

/// Every combination when there are few; else each setting varied alone around the defaults.
std::vector<Variant> variants_of(const PassDeclaration& pass)
{
    Variant defaults;
    std::vector<size_t> counts;
    for (const Selection& selection : pass.selections) {
        defaults.selections.push_back(selection.default_item);
        counts.push_back(selection.kind == Selection::Kind::layout ? 1 : selection.items.size());
    }
    std::vector<std::vector<Value>> values;
    for (const Param& param : pass.params) {
        defaults.statics.push_back(param.default_value);
        values.push_back(candidate_values(param));
        counts.push_back(values.back().size());
    }
    const auto set = [&](Variant& variant, size_t setting, size_t item) {
        if (setting < pass.selections.size())
            variant.selections[setting] = static_cast<int>(item);
        else
            variant.statics[setting - pass.selections.size()] = values[setting - pass.selections.size()][item];
    };
    size_t product = 1;
    for (const size_t count : counts)
        product = std::min(product * std::max<size_t>(count, 1), kMostVariants + 1);
    std::vector<Variant> variants = {defaults};
    if (product > kMostVariants) {
        for (size_t setting = 0; setting < counts.size(); ++setting)
            for (size_t item = 0; counts[setting] > 1 && item < counts[setting]; ++item)
                set(variants.emplace_back(defaults), setting, item);
        return variants;
    }
    for (size_t setting = 0; setting < counts.size(); ++setting) {
        if (counts[setting] < 2)
            continue;
        std::vector<Variant> grown;
        for (const Variant& variant : variants)
            for (size_t item = 0; item < counts[setting]; ++item)
                set(grown.emplace_back(variant), setting, item);
        variants = std::move(grown);
    }
    return variants;
}

/// Turns glslang's "'glow' : no matching overloaded function found" into what the author forgot in the header.
void explain(Error& error, const PassDeclaration& pass)
{
    if (!error.message.starts_with('\''))
        return;
    const std::string name = error.message.substr(1, error.message.find('\'', 1) - 1);
    const bool is_unknown_call = error.message.find("no matching overloaded function") != std::string::npos;
    const bool is_unknown_name = error.message.find("undeclared identifier") != std::string::npos;
    if (!is_unknown_call && !is_unknown_name)
        return;
    for (const char* read : {"camera", "frame", "lights", "elements"}) {
        const auto& names = glsl::accessor_names(read);
        if (std::find(names.begin(), names.end(), name) != names.end()) {
            error.hint = fmt::format("add \"{}\" to \"reads\"", read);
            return;
        }
    }
    const auto& globals = pass.body.globals;
    if (is_unknown_call && std::find(globals.begin(), globals.end(), name) == globals.end() && pass.find_input(name) < 0) {
        error.code = "undeclared_input";
        error.message = fmt::format("`{}` is called, but no input or function has that name", name);
        std::vector<std::string> known = globals;
        for (const InputPort& port : pass.inputs)
            known.push_back(port.name);
        const std::string near = closest(name, known);
        error.hint = near.empty() ? fmt::format("declare it: \"inputs\": {{ \"{}\": \"radiance\" }}", name) : fmt::format("did you mean `{}`?", near);
    } else if (is_unknown_name) {
        error.hint = "parameters are declared in the header's \"params\"";
    } else {
        error.hint = fmt::format("`{}` takes other arguments: inputs are called with one vec2", name);
    }
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
};

std::vector<Entry> entries_of(const PassDeclaration& pass)
{
    if (pass.kind == PassKind::image) {
        std::string mangled = pass.name + "(vf2;";
        if (pass.outputs.size() > 1)
            for (const OutputPort& port : pass.outputs)
                mangled += mangled_out(info(port.signal).components);
        return {{mangled, signature(pass), true}};
    }
    Entry vertex{pass.name + "_vertex(vf3;vf3;vf2;vf3;vf3;vf2;",
                 fmt::format("void {}_vertex(vec3 position, vec3 normal, vec2 texcoord, out vec3 placed, out vec3 facing, out vec2 uv)", pass.name)};
    Entry surface{pass.name + "_surface(vf3;vf3;vf2;", fmt::format("void {}_surface(vec3 placed, vec3 facing, vec2 uv", pass.name)};
    for (const OutputPort& port : pass.outputs) {
        if (port.signal == Signal::depth)
            continue;
        surface.mangled += mangled_out(info(port.signal).components);
        surface.text += fmt::format(", out {} {}", glsl_type(info(port.signal).components), port.name);
    }
    surface.text += ")";
    return {vertex, surface};
}

bool has_right_shape(const PassDeclaration& pass, const glslang::TIntermAggregate& function)
{
    const bool returns = pass.kind == PassKind::image && pass.outputs.size() == 1;
    if (!returns)
        return function.getType().getBasicType() == glslang::EbtVoid;
    const auto& type = function.getType();
    return type.getBasicType() == glslang::EbtFloat && static_cast<int>(width_of(type)) == info(pass.outputs.front().signal).components;
}

class Check {
public:
    explicit Check(PassDeclaration& pass) : pass_(pass), is_used_(pass.inputs.size(), false), access_(pass.inputs.size()) {}

    Result<void> run()
    {
        for (const Variant& variant : variants_of(pass_)) {
            check_variant(variant);
            if (errors_.size() > 20)
                break;
        }
        if (errors_.empty())
            report_unused();
        if (!errors_.empty())
            return tl::unexpected(std::move(errors_));
        for (size_t i = 0; i < pass_.inputs.size(); ++i)
            if (pass_.inputs[i].over != Over::scene)
                pass_.inputs[i].access = access_[i].value_or(Access{AccessClass::size_only, 0});
        return {};
    }

private:
    /// One mistake is seen under many variants: it is reported once.
    void report(Error error)
    {
        const bool is_known = std::any_of(errors_.begin(), errors_.end(), [&](const Error& other) {
            return other.code == error.code && other.message == error.message && other.where == error.where;
        });
        if (!is_known)
            errors_.push_back(std::move(error));
    }

    void check_variant(const Variant& variant)
    {
        PassDeclaration standing = pass_;
        for (size_t i = 0; i < standing.params.size(); ++i)
            standing.params[i].default_value = variant.statics[i];
        std::vector<std::string> sources;
        const std::string text = glsl::standalone_text(standing, variant.selections, sources);
        const auto parsed = ParsedShader::parse(text, sources);
        if (!parsed) {
            for (Error error : parsed.error()) {
                explain(error, pass_);
                report(std::move(error));
            }
            return;
        }
        for (const Entry& entry : entries_of(pass_))
            check_entry(entry, parsed->root());
    }

    void check_entry(const Entry& entry, TIntermNode* root)
    {
        Interpreter interpreter(pass_, root);
        const std::string name = entry.mangled.substr(0, entry.mangled.find('('));
        const auto overloads = interpreter.overloads(name);
        const Location start{pass_.file, pass_.body.first_line, 0};
        if (overloads.empty()) {
            report({"entry_missing", fmt::format("the file has no function `{}`", name), "write: " + entry.text, start});
            return;
        }
        const Location where{pass_.file, interpreter.function(overloads.front())->getLoc().line, 0};
        if (!interpreter.has_function(entry.mangled) || !has_right_shape(pass_, *interpreter.function(entry.mangled))) {
            report({"entry_signature", fmt::format("`{}` has the wrong parameters or result", name), "write: " + entry.text, where});
            return;
        }
        const auto result = interpreter.run(entry.mangled, entry.has_uv);
        for (const std::string& output : result.unwritten) {
            report({"output_unwritten", output.empty() ? fmt::format("`{}` does not return a value on every path", name)
                                                       : fmt::format("the output `{}` is not assigned on every path", output),
                    output.empty() ? "return a value at its end" : fmt::format("assign {} before the first branch", output), where});
        }
        for (size_t i = 0; i < result.readings.size(); ++i)
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
        else if (known->kind == AccessClass::warp || found.kind == AccessClass::warp || known->radius == Access::kUnknownRadius || found.radius == Access::kUnknownRadius)
            known = Access{AccessClass::gather, Access::kUnknownRadius};
        else
            known = Access{AccessClass::gather, std::max(known->radius, found.radius)};
    }

    void report_unused()
    {
        for (size_t i = 0; i < pass_.inputs.size(); ++i) {
            const InputPort& port = pass_.inputs[i];
            const bool gives_size = std::any_of(pass_.outputs.begin(), pass_.outputs.end(), [&](const OutputPort& o) { return o.size_of == port.name; });
            if (!is_used_[i] && port.over != Over::scene && !gives_size)
                report({"input_unused", fmt::format("the input `{}` is never read", port.name), fmt::format("call {}({}), or remove it", port.name, port.over == Over::sphere ? "direction, lod" : "uv"), port.where});
        }
    }

    PassDeclaration& pass_;
    Errors errors_;
    std::vector<bool> is_used_;
    std::vector<std::optional<Access>> access_;
};

} // namespace

Result<void> check_and_derive(PassDeclaration& pass)
{
    return Check(pass).run();
}

} // namespace passgraph::shader
