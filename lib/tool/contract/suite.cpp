// Runs the parts of the contract suite over one pass.
#include "tool/contract/suite.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <passgraph/gl/evaluate.hpp>

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

/// The parameters and selections, with the values they have under the settings, as GLSL constants.
std::string constants_of(const PassDeclaration& pass, const Settings& settings)
{
    std::string text;
    const auto find = [&](const std::string& name) {
        return std::find_if(settings.begin(), settings.end(), [&](const auto& setting) { return setting.name == name; });
    };
    for (const Param& param : pass.params) {
        std::array<double, 4> numbers = param.default_value.v;
        if (const auto set = find(param.name); set != settings.end()) {
            if (!set->numbers.empty())
                std::copy_n(set->numbers.begin(), std::min<size_t>(set->numbers.size(), 4), numbers.begin());
            else if (param.type == ParamType::bool_)
                numbers[0] = set->item == "true" ? 1.0 : 0.0;
            else
                numbers[0] = static_cast<double>(std::find(param.items.begin(), param.items.end(), set->item) - param.items.begin());
        }
        const bool is_whole = param.type == ParamType::int_ || param.type == ParamType::enum_;
        const int count = component_count(param.type);
        const std::string type = param.type == ParamType::bool_ ? "bool" : is_whole ? "int" : count == 1 ? "float" : fmt::format("vec{}", count);
        std::string value = fmt::format("{:#}", static_cast<float>(numbers[0]));
        for (int i = 1; i < count; ++i)
            value += fmt::format(", {:#}", static_cast<float>(numbers[static_cast<size_t>(i)]));
        text += fmt::format("const {0} {1} = {0}({2});\n", type, param.name, value);
        for (size_t item = 0; item < param.items.size(); ++item)
            text += fmt::format("const int {}_{} = {};\n", param.name, param.items[item], item);
    }
    for (const Selection& selection : pass.selections) {
        const auto set = find(selection.name);
        for (size_t item = 0; item < selection.items.size(); ++item) {
            text += fmt::format("const int {}_{} = {};\n", selection.name, selection.items[item], item);
            if (set == settings.end() ? static_cast<int>(item) == selection.default_item : set->item == selection.items[item])
                text += fmt::format("const int {} = {};\n", selection.name, item);
        }
    }
    return text;
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

Result<double> value_of(const Subject& subject, const std::string& expression, const Settings& settings)
{
    Evaluation evaluation;
    evaluation.declarations = constants_of(*subject.pass, settings);
    evaluation.expression = fmt::format("float({})", expression);
    evaluation.rows = {{}};
    const auto values = evaluate(evaluation, subject.loader);
    if (!values)
        return tl::unexpected(values.error());
    return static_cast<double>(values->front().front());
}

PassReport test_pass(const PassLibrary& library, const PassPtr& pass, GlLoader loader)
{
    PassReport report{.pass = pass->name, .file = pass->file, .lines = {}};
    Findings findings(report);
    const Subject subject{library, pass, loader, findings};
    check_values(subject);
    check_guards(subject);
    check_settings(subject);
    check_laws(subject);
    return report;
}

} // namespace passgraph::tool::contract
