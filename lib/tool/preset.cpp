// Reading and writing of presets.
#include "tool/preset.hpp"

#include <optional>

#include <fmt/format.h>

#include <passgraph/core/json.hpp>
#include <passgraph/core/json_value.hpp>

namespace passgraph::tool {
namespace {

/// A value of a preset; wrong_type when it is no value of any parameter.
std::optional<PassArguments::Setting> setting_of(const Json::Member& member, Errors& errors)
{
    PassArguments::Setting setting{.name = member.key, .numbers = {}, .item = {}, .where = member.value.where};
    const Json& value = member.value;
    bool is_right = value.is(Json::Kind::array) && !value.array.empty() && value.array.size() <= 4;
    for (const Json& number : value.array) {
        is_right = is_right && number.is(Json::Kind::number);
        setting.numbers.push_back(number.number);
    }
    if (value.is(Json::Kind::number))
        setting.numbers = {value.number};
    else if (value.is(Json::Kind::string))
        setting.item = value.string;
    else if (value.is(Json::Kind::boolean))
        setting.item = value.boolean ? "true" : "false";
    else if (!is_right) {
        report_wrong_type(value, fmt::format("`{}`", member.key), "a number, up to four numbers, true, false or a name", errors);
        return std::nullopt;
    }
    return setting;
}

/// A number as short as it reads back the same; JSON has no other numbers than finite ones, and settings neither.
std::string number_text(double number) { return fmt::format("{}", number); }

} // namespace

Result<std::vector<PassArguments::Setting>> read_preset(const std::string& file)
{
    const Result<std::string> text = read_text_file(file);
    if (!text)
        return tl::unexpected(text.error());
    const Result<Json> json = parse_json(*text, file);
    if (!json)
        return tl::unexpected(json.error());
    Errors errors;
    std::vector<PassArguments::Setting> settings;
    JsonFields fields(*json, "preset", errors);
    if (const Json* version = fields.require("passgraph_preset", Json::Kind::number); version && version->number != 1.0)
        errors.push_back({.code = "version_unknown",
                          .message = fmt::format("this is version {}, known is 1", version->number),
                          .where = version->where});
    fields.find("$schema");
    if (const Json* values = fields.require("values", Json::Kind::object))
        for (const Json::Member& member : values->members)
            if (auto setting = setting_of(member, errors))
                settings.push_back(std::move(*setting));
    fields.finish();
    if (!errors.empty())
        return tl::unexpected(std::move(errors));
    return settings;
}

std::string preset_text(const std::vector<PassArguments::Setting>& settings)
{
    std::string text = "{\n  \"passgraph_preset\": 1,\n  \"values\": {";
    for (size_t i = 0; i < settings.size(); ++i) {
        const PassArguments::Setting& setting = settings[i];
        text += fmt::format("{}\n    {}: {}", i == 0 ? "" : ",", JsonValue(setting.name).text(), value_text(setting));
    }
    return text + (settings.empty() ? "}\n}\n" : "\n  }\n}\n");
}

std::string value_text(const PassArguments::Setting& setting)
{
    if (!setting.item.empty())
        return setting.item == "true" || setting.item == "false" ? setting.item : JsonValue(setting.item).text();
    if (setting.numbers.size() == 1)
        return number_text(setting.numbers.front());
    std::vector<std::string> numbers;
    for (const double number : setting.numbers)
        numbers.push_back(number_text(number));
    return fmt::format("[{}]", fmt::join(numbers, ", "));
}

} // namespace passgraph::tool
