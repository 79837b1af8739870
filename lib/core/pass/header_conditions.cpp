// The parts of a pass header that say when work may be left out: "identity", "needs", "bound", "ignores".
#include <algorithm>

#include <fmt/format.h>

#include "core/pass/header_fields.hpp"
#include "passgraph/core/facts.hpp"

namespace passgraph::header {
namespace {

std::vector<std::string> names_of(const auto& ports)
{
    std::vector<std::string> names;
    for (const auto& port : ports)
        names.push_back(port.name);
    return names;
}

std::vector<std::string> fact_names()
{
    std::vector<std::string> names;
    for (const FactRow& row : all_facts())
        names.emplace_back(row.name);
    return names;
}

/// Why the pass cannot be its input, and the hint; empty when it can.
std::pair<std::string, std::string> why_not_identical(const PassDeclaration& pass, const InputPort& input)
{
    const OutputPort& output = pass.outputs.front();
    if (pass.outputs.size() > 1)
        return {fmt::format("it has {} outputs", pass.outputs.size()), "a pass with one output can be its input"};
    if (output.signal != input.signal)
        return {fmt::format("`{}` is {}, the output `{}` is {}", input.name, info(input.signal).name, output.name,
                            info(output.signal).name),
                "name an input of the output's signal"};
    if (input.over != Over::image)
        return {fmt::format("`{}` is no picture", input.name), "name an input that is a picture"};
    const bool is_of_other = !output.size_of.empty() && output.size_of != input.name;
    if (output.texels || output.scale != Ratio{} || is_of_other)
        return {fmt::format("the output `{}` has another extent than `{}`", output.name, input.name),
                is_of_other ? fmt::format("name `{}`, whose extent it has", output.size_of)
                            : "an output of another size is never its input"};
    return {};
}

/// A formula of the pass's own values, its inputs' largest components, and facts.
std::optional<Formula> read_condition(const Json& text, const PassDeclaration& pass, Errors& errors)
{
    std::vector<std::string> names = formula_names(pass);
    for (const std::string& name : names_of(pass.inputs))
        names.insert(names.end(), {name, name + std::string(kBehind)});
    for (const std::string& name : fact_names())
        names.push_back(name);
    return read_formula(text, names, "parameters, choices, inputs and facts", errors);
}

} // namespace

bool check_names(const Formula& formula, const std::vector<std::string>& names, std::string_view what, Errors& errors)
{
    bool is_known = true;
    for (const Formula::Name& name : formula.names())
        if (std::find(names.begin(), names.end(), name.text) == names.end()) {
            errors.push_back({"unknown_name", fmt::format("a formula cannot know `{}`", name.text), suggest(name.text, names, what),
                              name.where});
            is_known = false;
        }
    return is_known;
}

std::optional<Formula> read_formula(const Json& text, const std::vector<std::string>& names, std::string_view what, Errors& errors)
{
    if (!text.is(Json::Kind::string)) {
        report_wrong_type(text, "the formula", "a string", errors);
        return std::nullopt;
    }
    Result<Formula> formula = Formula::parse(text.string, text.where);
    if (!formula) {
        append(errors, formula.error());
        return std::nullopt;
    }
    return check_names(*formula, names, what, errors) ? std::optional(std::move(*formula)) : std::nullopt;
}

void check_is_input(const Json& named, const PassDeclaration& pass, Errors& errors)
{
    const int input = pass.find_input(named.string);
    if (input < 0) {
        errors.push_back({"unknown_input", fmt::format("there is no input `{}`", named.string),
                          suggest(named.string, names_of(pass.inputs), "inputs"), named.where});
    } else if (!pass.outputs.empty()) {
        const auto [why, hint] = why_not_identical(pass, pass.inputs[static_cast<size_t>(input)]);
        if (!why.empty())
            errors.push_back({"identity_mismatch", fmt::format("the pass cannot be its input `{}`: {}", named.string, why), hint,
                              named.where});
    }
}

void read_identity(const Json& identity, PassDeclaration& pass, Errors& errors)
{
    if (identity.is(Json::Kind::array)) {
        for (const Json& one : identity.array)
            read_identity(one, pass, errors);
        return;
    }
    JsonFields fields(identity, "\"identity\"", errors);
    const Json* when = fields.require("when", Json::Kind::string);
    const Json* is = fields.require("is", Json::Kind::string);
    if (is)
        check_is_input(*is, pass, errors);
    if (when && is)
        if (auto formula = read_condition(*when, pass, errors))
            pass.identities.push_back({std::move(*formula), is->string});
    fields.finish();
}

void read_needs(const Json& needs, PassDeclaration& pass, Errors& errors)
{
    const auto read = [&](const Json& fact) {
        if (!fact.is(Json::Kind::string))
            report_wrong_type(fact, "\"needs\"", "the name of a fact, or an array of names", errors);
        else if (find_fact(fact.string) == nullptr)
            errors.push_back({"unknown_fact", fmt::format("there is no fact `{}`", fact.string),
                              suggest(fact.string, fact_names(), "facts"), fact.where});
        else
            pass.needs.push_back(fact.string);
    };
    if (needs.is(Json::Kind::array))
        for (const Json& fact : needs.array)
            read(fact);
    else
        read(needs);
}

void read_bounds(const Json& bounds, PassDeclaration& pass, Errors& errors)
{
    const auto read = [&](OutputPort& port, const Json& text) {
        if (domain_of(port.signal).lowest == 0.0) {
            port.bound = read_condition(text, pass, errors);
            return;
        }
        errors.push_back({"bound_without_black", fmt::format("`{}` is {}, whose values may be negative: no largest one makes it black",
                                                             port.name, info(port.signal).name),
                          "bounds are of light, reflectance and coverage", text.where});
    };
    if (bounds.is(Json::Kind::string) && pass.outputs.size() == 1) {
        read(pass.outputs.front(), bounds);
        return;
    }
    if (!bounds.is(Json::Kind::object)) {
        report_wrong_type(bounds, "\"bound\"", pass.outputs.size() == 1 ? "a formula" : "an object of formulas by output", errors);
        return;
    }
    for (const Json::Member& member : bounds.members) {
        const int output = pass.find_output(member.key);
        if (output < 0)
            errors.push_back({"unknown_output", fmt::format("there is no output `{}`", member.key),
                              suggest(member.key, names_of(pass.outputs), "outputs"), member.where});
        else
            read(pass.outputs[static_cast<size_t>(output)], member.value);
    }
}

void read_ignores(const Json& ignores, PassDeclaration& pass, Errors& errors)
{
    for (const Json::Member& member : ignores.members) {
        const int input = pass.find_input(member.key);
        if (input < 0 || pass.inputs[static_cast<size_t>(input)].over == Over::scene)
            errors.push_back({"unknown_input", fmt::format("there is no input `{}`", member.key),
                              suggest(member.key, names_of(pass.inputs), "inputs"), member.where});
        else
            pass.inputs[static_cast<size_t>(input)].ignored_when = read_condition(member.value, pass, errors);
    }
}

} // namespace passgraph::header
