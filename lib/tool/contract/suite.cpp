// Runs the parts of the contract suite over one pass.
#include "tool/contract/suite.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <passgraph/core/facts.hpp>

namespace passgraph::tool::contract {
namespace {

PassArguments::Setting setting_of(const Param& param, double value)
{
    PassArguments::Setting setting;
    setting.name = param.name;
    if (param.type == ParamType::enum_)
        setting.item = param.items.at(static_cast<size_t>(value));
    else if (param.type == ParamType::bool_)
        setting.item = value != 0.0 ? "true" : "false";
    else
        setting.numbers.assign(static_cast<size_t>(component_count(param.type)), value);
    return setting;
}

/// The ends of a parameter's range; an open end is stood for by a value no scene is likely to pass.
std::array<double, 2> ends_of(const Param& param)
{
    constexpr double kFar = 1e4;
    if (param.type == ParamType::bool_)
        return {0.0, 1.0};
    if (param.type == ParamType::enum_)
        return {0.0, static_cast<double>(param.items.size()) - 1.0};
    return {std::isfinite(param.lowest) ? param.lowest : -kFar, std::isfinite(param.highest) ? param.highest : kFar};
}

} // namespace

std::vector<Settings> selection_variants(const PassDeclaration& pass)
{
    std::vector<Settings> variants = {{}};
    for (const Selection& selection : pass.selections)
        for (size_t item = 0; item < selection.items.size(); ++item)
            if (static_cast<int>(item) != selection.default_item) {
                PassArguments::Setting setting;
                setting.name = selection.name;
                setting.item = selection.items[item];
                variants.push_back({setting});
            }
    return variants;
}

std::vector<Settings> parameter_variants(const PassDeclaration& pass)
{
    std::vector<Settings> variants;
    Settings lowest;
    Settings highest;
    for (const Param& param : pass.params) {
        const auto [low, high] = ends_of(param);
        lowest.push_back(setting_of(param, low));
        highest.push_back(setting_of(param, high));
        variants.push_back({lowest.back()});
        variants.push_back({highest.back()});
        for (double item = low + 1.0; param.type == ParamType::enum_ && item < high; item += 1.0)
            variants.push_back({setting_of(param, item)});
    }
    const auto is_number = [](const Param& param) { return param.type == ParamType::float_ || param.type == ParamType::int_; };
    for (const Param& param : pass.params)
        for (const Param& other : pass.params) {
            const double value = other.default_value.v[0];
            if (param.name != other.name && param.type == other.type && is_number(param) && value >= param.lowest && value <= param.highest)
                variants.push_back({setting_of(param, value)});
        }
    if (pass.params.size() > 1) {
        variants.push_back(lowest);
        variants.push_back(highest);
    }
    return variants;
}

std::vector<Signal> generic_signals(const PassDeclaration& pass)
{
    const bool is_generic = std::any_of(pass.inputs.begin(), pass.inputs.end(),
                                        [](const InputPort& port) { return port.signal == Signal::color; });
    return is_generic ? std::vector<Signal>{Signal::radiance, Signal::display, Signal::radiance_alpha}
                      : std::vector<Signal>{Signal::radiance};
}

std::optional<Stage> open_stage(const Subject& subject, const StageOptions& options)
{
    Result<Stage> stage = Stage::create(subject.library, subject.pass, options, subject.loader);
    subject.findings.count_run("compiles");
    if (stage)
        return std::move(*stage);
    subject.findings.add({.check = "compiles",
                          .settings = to_text(options.settings),
                          .fed = "",
                          .place = fmt::format("{}x{}", options.extent.width, options.extent.height),
                          .got = to_text(stage.error().front()),
                          .expected = "a program",
                          .hint = ""});
    return std::nullopt;
}

std::optional<std::map<std::string, Picture>> run_stage(const Subject& subject, Stage& stage, const Feed& feed, const Scene* scene,
                                                        const StageOptions& options)
{
    auto outputs = stage.run(feed, scene);
    if (outputs)
        return std::move(*outputs);
    subject.findings.add({.check = "compiles",
                          .settings = to_text(options.settings),
                          .fed = "",
                          .place = fmt::format("{}x{}", options.extent.width, options.extent.height),
                          .got = to_text(outputs.error().front()),
                          .expected = "a picture",
                          .hint = ""});
    return std::nullopt;
}

PassArguments::Setting number_setting(const Param& param, double value)
{
    PassArguments::Setting setting;
    setting.name = param.name;
    setting.numbers.assign(static_cast<size_t>(component_count(param.type)), value);
    return setting;
}

double value_of(const Formula& formula, const PassDeclaration& pass, const Settings& settings, const std::string& black)
{
    return value_of(formula, pass, settings, black.empty() ? std::map<std::string, double, std::less<>>{} : std::map<std::string, double, std::less<>>{{black, 0.0}});
}

double value_of(const Formula& formula, const PassDeclaration& pass, const Settings& settings,
                const std::map<std::string, double, std::less<>>& largest)
{
    std::vector<Value> params;
    std::vector<int> selections;
    for (const Param& param : pass.params)
        params.push_back(param.default_value);
    for (const Selection& selection : pass.selections)
        selections.push_back(selection.default_item);
    const auto item_of = [](const std::vector<std::string>& items, const std::string& item) {
        return std::find(items.begin(), items.end(), item) - items.begin();
    };
    for (const PassArguments::Setting& setting : settings) {
        if (const int at = pass.find_selection(setting.name); at >= 0)
            selections[static_cast<size_t>(at)] = static_cast<int>(item_of(pass.selections[static_cast<size_t>(at)].items, setting.item));
        const int at = pass.find_param(setting.name);
        if (at < 0)
            continue;
        Value& value = params[static_cast<size_t>(at)];
        std::copy_n(setting.numbers.begin(), std::min<size_t>(setting.numbers.size(), 4), value.v.begin());
        if (setting.numbers.empty())
            value.v[0] = pass.params[static_cast<size_t>(at)].type == ParamType::bool_
                             ? (setting.item == "true" ? 1.0 : 0.0)
                             : static_cast<double>(item_of(pass.params[static_cast<size_t>(at)].items, setting.item));
    }
    return formula.value([&](std::string_view name) -> std::optional<Formula::Number> {
        if (const auto setting = find_setting(pass, params, selections, name))
            return setting;
        if (name.ends_with(kBehind)) // whatever is there must make no difference
            name.remove_suffix(kBehind.size());
        const auto known = largest.find(name);
        return Formula::Number{{known != largest.end() ? known->second : Facts::kUnknown}, 1};
    });
}

PassReport test_pass(const PassLibrary& library, const PassPtr& pass, GlLoader loader)
{
    PassReport report{.pass = pass->name, .file = pass->file, .lines = {}};
    Findings findings(report);
    const Subject subject{library, pass, loader, findings};
    check_values(subject);
    check_guards(subject);
    check_settings(subject);
    check_omissions(subject);
    check_laws(subject);
    return report;
}

} // namespace passgraph::tool::contract
