// Reads the inputs and outputs of a pass header.
#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "core/pass/header_fields.hpp"
#include "passgraph/core/codec.hpp"
#include "passgraph/core/pass_header.hpp"

namespace passgraph::header {
namespace {

template <class Enum, size_t N>
void read_word(JsonFields& fields, std::string_view key, const std::array<std::pair<const char*, Enum>, N>& words,
               Enum& into, Errors& errors)
{
    const Json* json = fields.find(key, Json::Kind::string);
    if (!json)
        return;
    std::vector<std::string> names;
    for (const auto& [word, value] : words) {
        if (json->string == word) {
            into = value;
            return;
        }
        names.emplace_back(word);
    }
    errors.push_back({"unknown_item", fmt::format("\"{}\" cannot be `{}`", key, json->string),
                      suggest(json->string, names, "words"), json->where});
}

void read_signal(const Json& json, Signal& into, Errors& errors)
{
    if (const auto signal = find_signal(json.string)) {
        into = *signal;
        return;
    }
    std::vector<std::string> names;
    for (const SignalInfo& row : all_signals())
        names.emplace_back(row.name);
    errors.push_back({"unknown_signal", fmt::format("there is no signal `{}`", json.string),
                      suggest(json.string, names, "signals"), json.where});
}

void read_default(const Json& json, InputPort& port, Errors& errors)
{
    const size_t components = static_cast<size_t>(info(port.signal).components);
    if (json.is(Json::Kind::number)) {
        port.default_value.v.fill(json.number);
        return;
    }
    bool fits = json.is(Json::Kind::array) && json.array.size() == components;
    for (const Json& item : json.array)
        fits = fits && item.is(Json::Kind::number);
    if (!fits) {
        report_wrong_type(json, fmt::format("input `{}`: \"default\"", port.name),
                          fmt::format("a number or {} numbers", components), errors);
        return;
    }
    for (size_t i = 0; i < components; ++i)
        port.default_value.v[i] = json.array[i].number;
}

constexpr std::array<std::pair<const char*, Filter>, 2> kFilters = {{{"nearest", Filter::nearest}, {"linear", Filter::linear}}};

/// "linear", or { "SELECTION": { "ITEM": "linear" } } where a rung or choice decides.
void read_filter(JsonFields& fields, const Json& input, InputPort& port, Errors& errors)
{
    const Json* json = input.find("filter");
    if (!json || !json->is(Json::Kind::object)) {
        read_word<Filter, 2>(fields, "filter", kFilters, port.filter, errors);
        return;
    }
    fields.find("filter");
    if (json->members.size() != 1 || !json->members.front().value.is(Json::Kind::object)) {
        report_wrong_type(*json, fmt::format("input `{}`: \"filter\"", port.name),
                          "a word, or one selection with a word for its items", errors);
        return;
    }
    port.filter_by = json->members.front().key;
    port.filter_where = json->members.front().where;
    const Json& items = json->members.front().value;
    JsonFields words(items, fmt::format("input `{}`: \"filter\"", port.name), errors);
    for (const Json::Member& item : items.members) {
        Filter filter = port.filter;
        read_word<Filter, 2>(words, item.key, kFilters, filter, errors);
        port.filter_of_item.emplace_back(item.key, filter);
    }
    words.finish();
}

InputPort read_input(const Json::Member& member, Errors& errors)
{
    InputPort port;
    port.name = member.key;
    port.where = member.where;
    check_name(member.key, "input", member.where, errors);
    if (member.value.is(Json::Kind::string)) {
        read_signal(member.value, port.signal, errors);
        return port;
    }
    JsonFields fields(member.value, fmt::format("input `{}`", member.key), errors);
    if (const Json* signal = fields.require("signal", Json::Kind::string))
        read_signal(*signal, port.signal, errors);
    read_filter(fields, member.value, port, errors);
    read_word<AddressMode, 3>(
        fields, "wrap",
        {{{"clamp", AddressMode::clamp}, {"mirror", AddressMode::mirror}, {"repeat", AddressMode::repeat}}}, port.wrap,
        errors);
    read_word<Over, 3>(fields, "over", {{{"image", Over::image}, {"sphere", Over::sphere}, {"table", Over::table}}},
                       port.over, errors);
    port.has_levels = fields.boolean("levels", false);
    port.is_optional = fields.boolean("optional", false);
    port.is_visited_once = fields.boolean("once", false);
    if (const Json* value = fields.find("default")) {
        read_default(*value, port, errors);
        if (!port.is_optional)
            errors.push_back({"default_unused", fmt::format("input `{}` has a default but must be wired", port.name),
                              "add \"optional\": true", value->where});
    }
    fields.finish();
    return port;
}

bool is_count(const Json& json) { return json.is_integer && json.number >= 1.0 && json.number <= 65536.0; }

void read_pair(JsonFields& fields, std::string_view key, std::optional<std::array<int, 2>>& into, Errors& errors)
{
    const Json* json = fields.find(key, Json::Kind::array);
    if (!json)
        return;
    if (json->array.size() != 2 || !is_count(json->array[0]) || !is_count(json->array[1])) {
        errors.push_back({"wrong_type", fmt::format("\"{}\" wants two whole numbers from 1 to 65536", key),
                          "[1, 2] is half", json->where});
        return;
    }
    into = std::array<int, 2>{static_cast<int>(json->array[0].number), static_cast<int>(json->array[1].number)};
}

void read_size(const Json& size, const PassDeclaration& pass, OutputPort& port, Errors& errors)
{
    JsonFields fields(size, fmt::format("output `{}`: \"size\"", port.name), errors);
    if (const Json* of = fields.find("of", Json::Kind::string)) {
        port.size_of = of->string;
        if (pass.find_input(of->string) < 0) {
            std::vector<std::string> names;
            for (const InputPort& input : pass.inputs)
                names.push_back(input.name);
            errors.push_back({"unknown_input", fmt::format("there is no input `{}`", of->string),
                              suggest(of->string, names, "inputs"), of->where});
            port.size_of.clear();
        }
    }
    std::optional<std::array<int, 2>> scale;
    read_pair(fields, "scale", scale, errors);
    if (scale)
        port.scale = {(*scale)[0], (*scale)[1]};
    read_pair(fields, "texels", port.texels, errors);
    fields.finish();
}

} // namespace

void check_name(const std::string& name, std::string_view what, const Location& where, Errors& errors)
{
    if (const std::string why = why_reserved(name); !why.empty())
        errors.push_back({"reserved_name", fmt::format("{} cannot be called `{}`: {}", what, name, why),
                          "choose another name", where});
}

void check_filters(const PassDeclaration& pass, Errors& errors)
{
    for (const InputPort& port : pass.inputs) {
        if (port.filter_by.empty())
            continue;
        std::vector<std::string> names;
        for (const Selection& selection : pass.selections)
            names.push_back(selection.name);
        const int by = pass.find_selection(port.filter_by);
        if (by < 0) {
            errors.push_back({"unknown_item",
                              fmt::format("input `{}`: there is no choice or ladder `{}` to decide the filter", port.name,
                                          port.filter_by),
                              suggest(port.filter_by, names, "choices and ladders"), port.filter_where});
            continue;
        }
        const auto& items = pass.selections[static_cast<size_t>(by)].items;
        for (const auto& [item, filter] : port.filter_of_item)
            if (std::find(items.begin(), items.end(), item) == items.end())
                errors.push_back({"unknown_item",
                                  fmt::format("input `{}`: `{}` has no item `{}`", port.name, port.filter_by, item),
                                  suggest(item, items, "items"), port.filter_where});
    }
}

void read_inputs(const Json& inputs, PassDeclaration& pass, Errors& errors)
{
    for (const Json::Member& member : inputs.members)
        pass.inputs.push_back(read_input(member, errors));
}

void read_outputs(const Json& outputs, PassDeclaration& pass, Errors& errors)
{
    for (const Json::Member& member : outputs.members) {
        OutputPort port;
        port.name = member.key;
        port.where = member.where;
        check_name(member.key, "output", member.where, errors);
        if (member.value.is(Json::Kind::string)) {
            read_signal(member.value, port.signal, errors);
        } else {
            JsonFields fields(member.value, fmt::format("output `{}`", member.key), errors);
            if (const Json* signal = fields.require("signal", Json::Kind::string))
                read_signal(*signal, port.signal, errors);
            if (const Json* size = fields.find("size", Json::Kind::object))
                read_size(*size, pass, port, errors);
            fields.finish();
        }
        const auto is_like_first = [&] {
            const OutputPort& first = pass.outputs.front();
            return first.size_of == port.size_of && first.scale == port.scale && first.texels == port.texels;
        };
        if (!pass.outputs.empty() && !is_like_first())
            errors.push_back(
                {"sizes_differ",
                 fmt::format("output `{}` has another size than `{}`", port.name, pass.outputs.front().name),
                 "one pass draws one extent: make two passes", port.where});
        pass.outputs.push_back(std::move(port));
    }
}

} // namespace passgraph::header
