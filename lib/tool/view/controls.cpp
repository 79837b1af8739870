// Controls from headers.
#include "tool/view/controls.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>


namespace passgraph::tool::view {
namespace {

Control::Kind kind_of(ParamType type)
{
    switch (type) {
    case ParamType::int_: return Control::Kind::whole;
    case ParamType::bool_: return Control::Kind::flag;
    case ParamType::enum_: return Control::Kind::item;
    case ParamType::color: return Control::Kind::color;
    case ParamType::vec2:
    case ParamType::vec3:
    case ParamType::vec4: return Control::Kind::vector;
    case ParamType::float_: break;
    }
    return Control::Kind::number;
}

std::string range_text(const Param& param)
{
    if (!std::isfinite(param.lowest) && !std::isfinite(param.highest))
        return "any";
    return fmt::format("{} to {}", param.lowest, param.highest);
}

std::string value_text(const Param& param, const Value& value)
{
    if (param.type == ParamType::enum_)
        return param.items[static_cast<size_t>(value.v[0])];
    if (param.type == ParamType::bool_)
        return value.v[0] != 0.0 ? "true" : "false";
    const int count = component_count(param.type);
    return fmt::format("{}", fmt::join(value.v.begin(), value.v.begin() + count, ", "));
}

Control control_of(const std::string& node, const Param& param, const Value& now, const Value& original, bool is_static)
{
    Control control{.kind = kind_of(param.type),
                    .place = node + "." + param.name,
                    .label = param.name,
                    .group = param.group,
                    .help = {},
                    .unit = param.unit,
                    .components = component_count(param.type),
                    .lowest = param.lowest,
                    .highest = param.highest,
                    .step = param.step,
                    .is_logarithmic = param.is_logarithmic,
                    .recompiles = is_static,
                    .items = param.items,
                    .value = now,
                    .original = original};
    control.help = param.label.empty() ? "" : param.label + "\n";
    if (control.kind != Control::Kind::flag && control.kind != Control::Kind::item)
        control.help += fmt::format("{}{}{}\n", range_text(param), param.unit.empty() ? "" : " ", param.unit);
    control.help += fmt::format("default {}{}", value_text(param, param.default_value), is_static ? "\na change compiles" : "");
    return control;
}

Control control_of(const std::string& node, const Selection& selection, int now, int original)
{
    const char* word = selection.kind == Selection::Kind::ladder   ? "a ladder: approximations of one thing"
                       : selection.kind == Selection::Kind::layout ? "how the images are stored"
                                                                   : "a choice between models";
    return {.kind = Control::Kind::item,
            .place = node + "." + selection.name,
            .label = selection.name,
            .group = {},
            .help = fmt::format("{}\ndefault {}\na change compiles", word, selection.items[static_cast<size_t>(selection.default_item)]),
            .unit = {},
            .recompiles = true,
            .items = selection.items,
            .value = Value(now),
            .original = Value(original)};
}

/// A pass's settings as they are: those of the declaration, changed by the file's or also by a person's. Checked on a graph
/// that holds this one pass, whose wires do not matter.
GraphNode node_with(const GraphDescription::Pass& use, const PassPtr& declaration, const Settings* settings)
{
    // A composite is looked at as one pass with the parameters it routes.
    auto plain = std::make_shared<PassDeclaration>(*declaration);
    plain->composite = nullptr;
    PassLibrary library;
    library.add(plain);
    Graph alone(library);
    PassArguments arguments;
    arguments.name = use.name;
    arguments.settings = use.settings;
    arguments.statics = use.statics;
    alone.add(plain->name, std::move(arguments));
    if (settings != nullptr)
        for (const auto& [place, setting] : *settings)
            if (place.size() > use.name.size() && place.starts_with(use.name) && place[use.name.size()] == '.')
                if (const Result<void> set = alone.set(place, setting); !set)
                    continue; // it fitted an older pass
    return alone.nodes().front();
}

/// What the header's `visible_if` says of a node's values.
bool is_visible(const Param& param, const GraphNode& node)
{
    const auto value_of = [&](std::string_view name) { return find_setting(*node.pass, node.params, node.selections, name); };
    return !param.visible_if || param.visible_if->value(value_of) != 0.0;
}

} // namespace

std::vector<PassControls> controls_of(const GraphDescription& description, const PassLibrary& library, const Settings& settings)
{
    std::vector<PassControls> all;
    for (const GraphDescription::Pass& use : description.passes) {
        const PassPtr pass = library.find(use.pass.text);
        if (!pass || (pass->params.empty() && pass->selections.empty()))
            continue;
        const GraphNode now = node_with(use, pass, &settings);
        const GraphNode original = node_with(use, pass, nullptr);
        PassControls controls{.name = use.name, .pass = pass->name, .summary = pass->summary, .controls = {}};
        for (size_t i = 0; i < pass->params.size(); ++i) {
            controls.controls.push_back(control_of(use.name, pass->params[i], now.params[i], original.params[i], now.is_static[i]));
            controls.controls.back().is_visible = is_visible(pass->params[i], now);
        }
        for (size_t i = 0; i < pass->selections.size(); ++i)
            controls.controls.push_back(control_of(use.name, pass->selections[i], now.selections[i], original.selections[i]));
        std::stable_sort(controls.controls.begin(), controls.controls.end(),
                         [](const Control& a, const Control& b) { return a.group < b.group; });
        all.push_back(std::move(controls));
    }
    return all;
}

PassArguments::Setting setting_of(const Control& control, const Value& value)
{
    PassArguments::Setting setting{.name = control.place, .numbers = {}, .item = {}, .where = {}};
    if (control.kind == Control::Kind::item)
        setting.item = control.items[static_cast<size_t>(value.v[0])];
    else if (control.kind == Control::Kind::flag)
        setting.item = value.v[0] != 0.0 ? "true" : "false";
    else
        setting.numbers.assign(value.v.begin(), value.v.begin() + control.components);
    return setting;
}

Value fitted(const Control& control, Value value)
{
    const bool is_item = control.kind == Control::Kind::item;
    const double lowest = is_item || control.kind == Control::Kind::flag ? 0.0 : control.lowest;
    const double highest = is_item                              ? static_cast<double>(control.items.size()) - 1.0
                           : control.kind == Control::Kind::flag ? 1.0
                                                                 : control.highest;
    const double step = control.kind == Control::Kind::number || control.kind == Control::Kind::vector ? control.step : 1.0;
    for (int i = 0; i < control.components; ++i) {
        double& x = value.v[static_cast<size_t>(i)];
        if (!std::isfinite(x))
            x = control.original.v[static_cast<size_t>(i)];
        if (step > 0.0 && control.kind != Control::Kind::color) {
            const double from = std::isfinite(lowest) ? lowest : 0.0;
            x = from + std::round((x - from) / step) * step;
        }
        x = std::clamp(x, lowest, highest);
    }
    return value;
}

std::vector<std::string> apply_settings(const Settings& settings, Graph& graph)
{
    std::vector<std::string> ignored;
    for (const auto& [place, setting] : settings)
        if (const Result<void> set = graph.set(place, setting); !set)
            ignored.push_back(place);
    return ignored;
}

} // namespace passgraph::tool::view
