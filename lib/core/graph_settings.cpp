// Settings by name, checked against the declaration of the node's pass.
#include "core/graph_settings.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "passgraph/core/codec.hpp"

namespace passgraph {

std::vector<std::string> setting_names(const PassDeclaration& pass)
{
    std::vector<std::string> names;
    for (const Param& param : pass.params)
        names.push_back(param.name);
    for (const Selection& selection : pass.selections)
        names.push_back(selection.name);
    return names;
}

namespace {

int item_index(const std::vector<std::string>& items, std::string_view item)
{
    const auto found = std::find(items.begin(), items.end(), item);
    return found == items.end() ? -1 : static_cast<int>(found - items.begin());
}

/// A number given where an item is wanted names it: rungs such as taps 5, 9, 13 look like numbers.
std::string item_text(const PassArguments::Setting& setting)
{
    if (!setting.item.empty() || setting.numbers.size() != 1)
        return setting.item;
    return fmt::format("{}", setting.numbers.front());
}

void set_selection(GraphNode& node, size_t index, const PassArguments::Setting& setting, Errors& errors)
{
    const Selection& selection = node.pass->selections[index];
    const std::string wanted = item_text(setting);
    const int item = item_index(selection.items, wanted);
    if (item < 0) {
        errors.push_back({"unknown_item", fmt::format("{}.{} cannot be `{}`", node.name, selection.name, wanted),
                          suggest(wanted, selection.items, "items"), setting.where});
        return;
    }
    node.selections[index] = item;
}

std::string expected_text(const Param& param)
{
    switch (param.type) {
    case ParamType::bool_:
        return "true or false";
    case ParamType::int_:
        return "a whole number";
    case ParamType::enum_:
        return "one of its items";
    case ParamType::float_:
        return "a number";
    default:
        return fmt::format("{} numbers", component_count(param.type));
    }
}

bool has_right_type(const Param& param, const std::vector<double>& numbers)
{
    if (numbers.size() != static_cast<size_t>(component_count(param.type)))
        return false;
    const double first = numbers.front();
    if (param.type == ParamType::int_)
        return std::floor(first) == first && std::abs(first) <= 2147483647.0;
    if (param.type == ParamType::bool_)
        return first == 0.0 || first == 1.0;
    return param.type != ParamType::enum_;
}

/// A number that came from a binary32 as the decimal it was written as: 0.1f means 0.1, which is inside [0.1, 1].
double as_written(double number)
{
    const float narrow = static_cast<float>(number);
    if (static_cast<double>(narrow) != number)
        return number;
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), narrow).ptr;
    std::from_chars(digits.data(), end, number);
    return number;
}

void set_param(GraphNode& node, size_t index, const PassArguments::Setting& setting, Errors& errors)
{
    const Param& param = node.pass->params[index];
    const std::string place = fmt::format("{}.{}", node.name, param.name);
    if (param.type == ParamType::enum_) {
        const int item = item_index(param.items, setting.item);
        if (item < 0) {
            errors.push_back({"unknown_item", fmt::format("{} cannot be `{}`", place, item_text(setting)),
                              suggest(setting.item, param.items, "items"), setting.where});
        } else {
            node.params[index] = Value(item);
        }
        return;
    }
    std::vector<double> numbers = setting.numbers;
    if (param.type == ParamType::bool_ && (setting.item == "true" || setting.item == "false"))
        numbers = {setting.item == "true" ? 1.0 : 0.0};
    if (!has_right_type(param, numbers)) {
        const std::string got =
            setting.item.empty() ? fmt::format("{} numbers", numbers.size()) : "`" + setting.item + "`";
        errors.push_back(
            {"wrong_type",
             fmt::format("{} is a {}: expected {}, got {}", place, name(param.type), expected_text(param), got), "",
             setting.where});
        return;
    }
    Value value;
    for (size_t i = 0; i < numbers.size(); ++i) {
        if (param.type != ParamType::int_)
            numbers[i] = as_written(numbers[i]);
        if (!(numbers[i] >= param.lowest && numbers[i] <= param.highest) || !std::isfinite(numbers[i])) {
            errors.push_back(
                {"param_out_of_range",
                 fmt::format("{} = {} is outside [{}, {}]", place, numbers[i], param.lowest, param.highest),
                 fmt::format("give {} between {} and {}", expected_text(param), param.lowest, param.highest),
                 setting.where});
            return;
        }
        value.v[i] = numbers[i];
    }
    node.params[index] = value;
}

} // namespace

GraphNode node_of(PassPtr pass, std::string name, const Location& where)
{
    GraphNode node;
    node.name = std::move(name);
    node.where = where;
    node.inputs.resize(pass->inputs.size());
    node.codecs.resize(pass->outputs.size());
    for (const Param& param : pass->params) {
        node.params.push_back(param.default_value);
        node.is_static.push_back(param.is_static);
    }
    for (const Selection& selection : pass->selections)
        node.selections.push_back(selection.default_item);
    node.pass = std::move(pass);
    return node;
}

void apply_setting(GraphNode& node, const PassArguments::Setting& setting, Errors& errors)
{
    const int param = node.pass->find_param(setting.name);
    const int selection = node.pass->find_selection(setting.name);
    if (param >= 0) {
        set_param(node, static_cast<size_t>(param), setting, errors);
    } else if (selection >= 0) {
        set_selection(node, static_cast<size_t>(selection), setting, errors);
    } else {
        errors.push_back(
            {"unknown_param",
             fmt::format("{} ({}) has no parameter, choice or ladder `{}`", node.name, node.pass->name, setting.name),
             suggest(setting.name, setting_names(*node.pass), "settings"), setting.where});
    }
}

void apply_codec(GraphNode& node, const PassArguments::Setting& setting, Errors& errors)
{
    const int output = node.pass->find_output(setting.name);
    if (output < 0) {
        std::vector<std::string> names;
        for (const OutputPort& port : node.pass->outputs)
            names.push_back(port.name);
        errors.push_back({"unknown_image",
                          fmt::format("{} ({}) has no output `{}`", node.name, node.pass->name, setting.name),
                          suggest(setting.name, names, "outputs"), setting.where});
        return;
    }
    // A generic output's signal is known only later; encode checks the codec against it.
    const Signal signal = node.pass->outputs[static_cast<size_t>(output)].signal;
    if (signal != Signal::color && !find_codec(signal, setting.item)) {
        errors.push_back({"unknown_codec",
                          fmt::format("{}.{} is {}, which no codec `{}` stores", node.name, setting.name,
                                      info(signal).name, setting.item),
                          suggest(setting.item, codec_names(signal), "codecs"), setting.where});
        return;
    }
    node.codecs[static_cast<size_t>(output)] = setting.item;
}

} // namespace passgraph
