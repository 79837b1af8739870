// Reads the parameters, choices and ladders of a pass header.
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "core/pass/header_fields.hpp"

namespace passgraph::header {
namespace {

std::optional<ParamType> find_type(const std::string& word)
{
    for (int i = 0; i <= static_cast<int>(ParamType::vec4); ++i)
        if (word == name(static_cast<ParamType>(i)))
            return static_cast<ParamType>(i);
    return std::nullopt;
}

std::vector<std::string> type_names()
{
    std::vector<std::string> names;
    for (int i = 0; i <= static_cast<int>(ParamType::vec4); ++i)
        names.emplace_back(name(static_cast<ParamType>(i)));
    return names;
}

/// A name in an item list: a string, or a number as rungs often are.
std::vector<std::string> read_items(const Json& items, Errors& errors)
{
    std::vector<std::string> names;
    for (const Json& item : items.array) {
        std::string text = item.is(Json::Kind::number) ? fmt::format("{}", item.number) : item.string;
        const auto is_allowed = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; };
        if (text.empty() || !std::all_of(text.begin(), text.end(), is_allowed))
            errors.push_back({"wrong_type", fmt::format("`{}` cannot name an item", text),
                              "items are letters, digits and underscores", item.where});
        else if (std::find(names.begin(), names.end(), text) != names.end())
            errors.push_back(
                {"duplicate_name", fmt::format("the item `{}` stands twice", text), "remove one", item.where});
        names.push_back(std::move(text));
    }
    return names;
}

int read_default_item(const Json* json, const std::vector<std::string>& items, Errors& errors)
{
    if (!json)
        return 0;
    const std::string wanted = json->is(Json::Kind::number) ? fmt::format("{}", json->number) : json->string;
    const auto found = std::find(items.begin(), items.end(), wanted);
    if (found == items.end()) {
        errors.push_back({"unknown_item", fmt::format("the default `{}` is no item", wanted),
                          suggest(wanted, items, "items"), json->where});
        return 0;
    }
    return static_cast<int>(found - items.begin());
}

bool read_value(const Json& json, Param& param)
{
    const size_t count = static_cast<size_t>(component_count(param.type));
    if (param.type == ParamType::bool_) {
        param.default_value = Value(json.boolean ? 1.0 : 0.0);
        return json.is(Json::Kind::boolean);
    }
    if (count == 1) {
        param.default_value = Value(json.number);
        return json.is(Json::Kind::number) &&
               (param.type != ParamType::int_ || (json.is_integer && std::abs(json.number) <= 2147483647.0));
    }
    if (!json.is(Json::Kind::array) || json.array.size() != count)
        return false;
    for (size_t i = 0; i < count; ++i) {
        if (!json.array[i].is(Json::Kind::number))
            return false;
        param.default_value.v[i] = json.array[i].number;
    }
    return true;
}

void read_short_form(const Json& json, Param& param, Errors& errors)
{
    if (json.is(Json::Kind::boolean))
        param.type = ParamType::bool_;
    else if (json.is(Json::Kind::array) && json.array.size() >= 2 && json.array.size() <= 4)
        param.type = json.array.size() == 2   ? ParamType::vec2
                     : json.array.size() == 3 ? ParamType::vec3
                                              : ParamType::vec4;
    if (!read_value(json, param))
        report_wrong_type(json, fmt::format("param `{}`", param.name),
                          "a number, true, false, two to four numbers, or an object", errors);
}

void read_range(JsonFields& fields, Param& param, Errors& errors)
{
    if (param.type == ParamType::color) {
        param.lowest = 0.0;
        param.highest = 1.0;
    }
    std::array<float, 2> given{};
    const Json* range = fields.find("range");
    if (!range || !fields.numbers("range", 2, given.data()))
        return;
    param.lowest = range->array[0].number;
    param.highest = range->array[1].number;
    if (param.lowest > param.highest)
        errors.push_back({"range_empty", fmt::format("param `{}`: the range ends before it starts", param.name),
                          "swap its ends", range->where});
}

void read_long_form(const Json& json, Param& param, Errors& errors)
{
    JsonFields fields(json, fmt::format("param `{}`", param.name), errors);
    if (const Json* type = fields.require("type", Json::Kind::string)) {
        if (const auto found = find_type(type->string))
            param.type = *found;
        else
            errors.push_back({"unknown_item", fmt::format("there is no parameter type `{}`", type->string),
                              suggest(type->string, type_names(), "types"), type->where});
    }
    if (const Json* items = fields.find("items", Json::Kind::array))
        param.items = read_items(*items, errors);
    if (param.type == ParamType::enum_ && param.items.empty())
        errors.push_back({"field_missing", fmt::format("param `{}` lacks \"items\"", param.name),
                          "an enum names its items", json.where});
    const Json* value = fields.require("default");
    if (value && param.type == ParamType::enum_)
        param.default_value = Value(read_default_item(value, param.items, errors));
    else if (value && !read_value(*value, param))
        report_wrong_type(*value, fmt::format("param `{}`: \"default\"", param.name),
                          fmt::format("a value of type {}", name(param.type)), errors);
    read_range(fields, param, errors);
    param.step = fields.number("step", 0.0);
    param.unit = fields.text("unit");
    param.label = fields.text("label");
    param.group = fields.text("group");
    if (const Json* condition = fields.find("visible_if", Json::Kind::string)) {
        if (Result<Formula> formula = Formula::parse(condition->string, condition->where))
            param.visible_if = std::move(*formula);
        else
            append(errors, formula.error());
    }
    param.is_static = fields.boolean("static", false);
    if (const Json* scale = fields.find("scale", Json::Kind::string)) {
        param.is_logarithmic = scale->string == "log";
        if (!param.is_logarithmic && scale->string != "linear")
            errors.push_back({"unknown_item", fmt::format("a scale cannot be `{}`", scale->string),
                              suggest(scale->string, {"linear", "log"}, "scales"), scale->where});
    }
    fields.finish();
    for (int i = 0; value && param.lowest <= param.highest && i < component_count(param.type); ++i) {
        const double component = param.default_value.v[static_cast<size_t>(i)];
        if (param.type != ParamType::enum_ && !(component >= param.lowest && component <= param.highest)) {
            errors.push_back({"param_out_of_range",
                              fmt::format("param `{}`: the default {} is outside [{}, {}]", param.name, component,
                                          param.lowest, param.highest),
                              "", value->where});
        }
    }
}

} // namespace

void read_params(const Json& params, PassDeclaration& pass, Errors& errors)
{
    for (const Json::Member& member : params.members) {
        Param param;
        param.name = member.key;
        param.where = member.where;
        check_name(member.key, "parameter", member.where, errors);
        if (member.value.is(Json::Kind::object))
            read_long_form(member.value, param, errors);
        else
            read_short_form(member.value, param, errors);
        pass.params.push_back(std::move(param));
    }
}

void read_selections(const Json& selections, Selection::Kind kind, PassDeclaration& pass, Errors& errors)
{
    for (const Json::Member& member : selections.members) {
        Selection selection;
        selection.name = member.key;
        selection.kind = kind;
        selection.where = member.where;
        check_name(member.key, kind == Selection::Kind::ladder ? "ladder" : "choice", member.where, errors);
        const Json* default_item = nullptr;
        const Json* items = member.value.is(Json::Kind::array) ? &member.value : nullptr;
        if (!items) {
            JsonFields fields(member.value, fmt::format("`{}`", member.key), errors);
            items = fields.require("items", Json::Kind::array);
            default_item = fields.find("default");
            fields.text("label");
            fields.text("summary");
            if (kind == Selection::Kind::ladder)
                selection.reference = fields.text("reference");
            fields.finish();
        }
        if (items)
            selection.items = read_items(*items, errors);
        if (items && selection.items.empty())
            errors.push_back({"field_missing", fmt::format("`{}` names no item", member.key), "", member.where});
        selection.default_item = read_default_item(default_item, selection.items, errors);
        pass.selections.push_back(std::move(selection));
    }
}

} // namespace passgraph::header
