// A reader of small conditions.
#include "tool/view/visible_if.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <optional>
#include <string_view>
#include <vector>

namespace passgraph::tool::view {
namespace {

std::string_view trimmed(std::string_view text)
{
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front())))
        text.remove_prefix(1);
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back())))
        text.remove_suffix(1);
    return text;
}

std::vector<std::string_view> parts_of(std::string_view text, std::string_view between)
{
    std::vector<std::string_view> parts;
    for (size_t at = text.find(between); at != std::string_view::npos; at = text.find(between)) {
        parts.push_back(text.substr(0, at));
        text.remove_prefix(at + between.size());
    }
    parts.push_back(text);
    return parts;
}

/// A side of a comparison: a setting's value with its items, or a number.
struct Side {
    double number = 0.0;
    const std::vector<std::string>* items = nullptr;
};

std::optional<Side> side_of(std::string_view text, const GraphNode& node)
{
    if (const int param = node.pass->find_param(text); param >= 0)
        return Side{node.params[static_cast<size_t>(param)].v[0], &node.pass->params[static_cast<size_t>(param)].items};
    if (const int selection = node.pass->find_selection(text); selection >= 0)
        return Side{static_cast<double>(node.selections[static_cast<size_t>(selection)]),
                    &node.pass->selections[static_cast<size_t>(selection)].items};
    if (text == "true" || text == "false")
        return Side{text == "true" ? 1.0 : 0.0};
    Side side;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), side.number);
    if (failure != std::errc() || end != text.data() + text.size())
        return std::nullopt;
    return side;
}

/// The item of the setting on the other side; GLSL's name of an item, SETTING_ITEM, is one too.
std::optional<Side> item_of(std::string_view text, std::string_view setting, const Side& other)
{
    if (other.items == nullptr)
        return std::nullopt;
    if (text.starts_with(setting) && text.size() > setting.size() && text[setting.size()] == '_')
        text.remove_prefix(setting.size() + 1);
    const auto found = std::find(other.items->begin(), other.items->end(), text);
    return found == other.items->end() ? std::nullopt : std::optional(Side{static_cast<double>(found - other.items->begin())});
}

std::optional<bool> compare(std::string_view text, const GraphNode& node)
{
    for (const std::string_view sign : {"==", "!=", "<=", ">=", "<", ">"}) { // those of two letters first
        const size_t at = text.find(sign);
        if (at == std::string_view::npos)
            continue;
        const std::string_view left_text = trimmed(text.substr(0, at));
        const std::string_view right_text = trimmed(text.substr(at + sign.size()));
        const std::optional<Side> left = side_of(left_text, node);
        if (!left)
            return std::nullopt;
        std::optional<Side> right = item_of(right_text, left_text, *left);
        if (!right)
            right = side_of(right_text, node);
        if (!right)
            return std::nullopt;
        const double a = left->number;
        const double b = right->number;
        return sign == "==" ? a == b : sign == "!=" ? a != b : sign == "<=" ? a <= b : sign == ">=" ? a >= b : sign == "<" ? a < b : a > b;
    }
    const bool is_negated = text.starts_with('!');
    const std::optional<Side> flag = side_of(trimmed(is_negated ? text.substr(1) : text), node);
    return flag ? std::optional((flag->number != 0.0) != is_negated) : std::nullopt;
}

} // namespace

bool is_visible(const std::string& visible_if, const GraphNode& node)
{
    if (trimmed(visible_if).empty())
        return true;
    for (const std::string_view alternative : parts_of(visible_if, "||")) {
        bool holds = true;
        for (const std::string_view condition : parts_of(alternative, "&&"))
            holds = holds && compare(trimmed(condition), node).value_or(true);
        if (holds)
            return true;
    }
    return false;
}

} // namespace passgraph::tool::view
