// JSON that is written: the value, and its text by nlohmann.
#include "passgraph/core/json_value.hpp"

#include <algorithm>
#include <cassert>

#include <nlohmann/json.hpp>

namespace passgraph {

struct JsonValue::Writer {
    nlohmann::ordered_json operator()(std::monostate) const { return nullptr; }
    nlohmann::ordered_json operator()(const Array& array) const
    {
        auto json = nlohmann::ordered_json::array();
        for (const JsonValue& element : array)
            json.push_back(std::visit(*this, element.value_));
        return json;
    }
    nlohmann::ordered_json operator()(const Members& members) const
    {
        auto json = nlohmann::ordered_json::object();
        for (const auto& [key, value] : members)
            json[key] = std::visit(*this, value.value_);
        return json;
    }
    nlohmann::ordered_json operator()(const auto& scalar) const { return scalar; }
};

JsonValue::JsonValue(std::initializer_list<JsonValue> list)
{
    const auto is_member = [](const JsonValue& element) {
        const Array* pair = std::get_if<Array>(&element.value_);
        return pair != nullptr && pair->size() == 2 && std::holds_alternative<std::string>(pair->front().value_);
    };
    if (!std::all_of(list.begin(), list.end(), is_member)) {
        value_ = Array(list);
        return;
    }
    value_ = Members();
    for (const JsonValue& element : list) {
        const Array& pair = std::get<Array>(element.value_);
        (*this)[std::get<std::string>(pair.front().value_)] = pair.back();
    }
}

JsonValue JsonValue::array(std::initializer_list<JsonValue> elements)
{
    JsonValue value;
    value.value_ = Array(elements);
    return value;
}

JsonValue JsonValue::object()
{
    JsonValue value;
    value.value_ = Members();
    return value;
}

JsonValue& JsonValue::operator[](std::string_view key)
{
    if (std::holds_alternative<std::monostate>(value_))
        value_ = Members();
    assert(std::holds_alternative<Members>(value_));
    auto& members = std::get<Members>(value_);
    for (auto& [name, value] : members)
        if (name == key)
            return value;
    return members.emplace_back(key, JsonValue()).second;
}

void JsonValue::push_back(JsonValue element)
{
    if (std::holds_alternative<std::monostate>(value_))
        value_ = Array();
    assert(std::holds_alternative<Array>(value_));
    std::get<Array>(value_).push_back(std::move(element));
}

const JsonValue& JsonValue::front() const { return std::get<Array>(value_).front(); }

JsonValue& JsonValue::back() { return std::get<Array>(value_).back(); }

void JsonValue::update(const JsonValue& other)
{
    for (const auto& [key, value] : std::get<Members>(other.value_))
        (*this)[key] = value;
}

std::string JsonValue::text(int indent) const
{
    return std::visit(Writer(), value_).dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

} // namespace passgraph
