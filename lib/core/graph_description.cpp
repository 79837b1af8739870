// Reads a graph file's form: which passes, which wires, which values, each with its place.
#include <array>

#include <fmt/format.h>

#include "passgraph/core/graph_file.hpp"

namespace passgraph {
namespace {

using Setting = PassArguments::Setting;

class Reader {
public:
    explicit Reader(const std::string& file) { graph_.file = file; }

    Result<GraphDescription> read(const Json& root)
    {
        JsonFields fields(root, "graph", errors_);
        if (const Json* version = fields.require("passgraph", Json::Kind::number); version && version->number != 1.0) {
            errors_.push_back({"version_unknown", fmt::format("this is version {}, known is 1", version->number), "",
                               version->where});
        }
        graph_.composite_name = fields.text("pass");
        graph_.summary = fields.text("summary");
        graph_.source = fields.text("source");
        fields.find("$schema");
        if (const Json* contract = fields.find("contract", Json::Kind::object))
            graph_.contract = *contract;
        if (const Json* inputs = fields.find("inputs", Json::Kind::object))
            for (const Json::Member& member : inputs->members)
                read_input(member);
        if (const Json* passes = fields.require("passes", Json::Kind::object))
            for (const Json::Member& member : passes->members)
                read_pass(member);
        if (const Json* params = fields.find("params", Json::Kind::object))
            for (const Json::Member& member : params->members)
                read_param(member);
        if (const Json* outputs = fields.require("outputs", Json::Kind::object)) {
            for (const Json::Member& member : outputs->members)
                if (const auto image = text_of(member.value, fmt::format("output `{}`", member.key)))
                    graph_.outputs.push_back({member.key, *image, member.where});
        }
        fields.finish();
        if (!errors_.empty())
            return tl::unexpected(std::move(errors_));
        return std::move(graph_);
    }

private:
    std::optional<NamedPlace> text_of(const Json& json, const std::string& what)
    {
        if (!json.is(Json::Kind::string)) {
            report_wrong_type(json, what, "a string", errors_);
            return std::nullopt;
        }
        return NamedPlace{json.string, json.where};
    }

    void take_name(const std::string& name, const Location& where)
    {
        for (const auto& input : graph_.inputs)
            if (input.name == name)
                errors_.push_back({"duplicate_name", fmt::format("`{}` names an input and a pass", name),
                                   "inputs and passes share one namespace: rename one", where});
        if (name.empty() || name.find('.') != std::string::npos)
            errors_.push_back({"name_malformed", fmt::format("`{}` cannot be a name", name),
                               "names are not empty and hold no dot", where});
    }

    void read_input(const Json::Member& member)
    {
        GraphDescription::Input input{.name = member.key, .where = member.where};
        take_name(member.key, member.where);
        const Json* signal_name = nullptr;
        if (member.value.is(Json::Kind::string)) {
            signal_name = &member.value;
        } else {
            JsonFields fields(member.value, fmt::format("input `{}`", member.key), errors_);
            const Json* kind = fields.find("kind", Json::Kind::string);
            const Json* over = fields.find("over", Json::Kind::string);
            signal_name = fields.find("signal", Json::Kind::string);
            const Json* optional = fields.find("optional", Json::Kind::boolean);
            input.is_optional = optional && optional->boolean;
            if (input.is_optional && graph_.composite_name.empty())
                errors_.push_back({"optional_unused", fmt::format("input `{}` of a graph cannot be optional", member.key),
                                   "only a composite's can: give the file a \"pass\" name", optional->where});
            fields.finish();
            if (kind && kind->string == "scene") {
                input.kind = GraphNode::Kind::scene;
            } else if (kind && kind->string != "image") {
                errors_.push_back({"unknown_item", fmt::format("an input cannot be of kind `{}`", kind->string),
                                   suggest(kind->string, {"scene", "image"}, "kinds"), kind->where});
            } else if (!signal_name && member.value.is(Json::Kind::object)) {
                errors_.push_back({"field_missing", fmt::format("input `{}` lacks \"signal\"", member.key),
                                   "say what its values mean, such as \"radiance\"", member.value.where});
            }
            if (over && over->string == "sphere") {
                input.kind = GraphNode::Kind::cube;
            } else if (over && over->string != "image") {
                errors_.push_back({"unknown_item", fmt::format("an input cannot be over `{}`", over->string),
                                   suggest(over->string, {"image", "sphere"}, "domains"), over->where});
            }
        }
        if (signal_name && signal_name->is(Json::Kind::string)) {
            if (const auto signal = find_signal(signal_name->string)) {
                input.signal = *signal;
            } else {
                std::vector<std::string> names;
                for (const SignalInfo& row : all_signals())
                    names.emplace_back(row.name);
                errors_.push_back({"unknown_signal", fmt::format("there is no signal `{}`", signal_name->string),
                                   suggest(signal_name->string, names, "signals"), signal_name->where});
            }
        }
        graph_.inputs.push_back(std::move(input));
    }

    std::optional<Setting> read_setting(const Json::Member& member)
    {
        Setting setting{.name = member.key, .numbers = {}, .item = {}, .where = member.value.where};
        const Json& value = member.value;
        if (value.is(Json::Kind::string)) {
            setting.item = value.string;
        } else if (value.is(Json::Kind::number)) {
            setting.numbers = {value.number};
        } else if (value.is(Json::Kind::boolean)) {
            setting.numbers = {value.boolean ? 1.0 : 0.0};
        } else if (value.is(Json::Kind::array) && value.array.size() <= 4) {
            for (const Json& item : value.array) {
                if (!item.is(Json::Kind::number)) {
                    report_wrong_type(item, fmt::format("`{}`", member.key), "a number", errors_);
                    return std::nullopt;
                }
                setting.numbers.push_back(item.number);
            }
        } else {
            report_wrong_type(value, fmt::format("`{}`", member.key),
                              "a number, up to four numbers, true, false or a name", errors_);
            return std::nullopt;
        }
        return setting;
    }

    void read_settings(const Json* object, std::vector<Setting>& into)
    {
        if (!object)
            return;
        for (const Json::Member& member : object->members)
            if (auto setting = read_setting(member))
                into.push_back(std::move(*setting));
    }

    void read_size(JsonFields& fields, GraphDescription::Pass& pass)
    {
        if (const Json* scale = fields.find("scale", Json::Kind::array)) {
            const auto whole = [](const Json& j) { return j.is_integer && j.number >= 1.0 && j.number <= 65536.0; };
            if (scale->array.size() == 2 && whole(scale->array[0]) && whole(scale->array[1])) {
                pass.scale = Ratio{static_cast<int>(scale->array[0].number), static_cast<int>(scale->array[1].number)};
            } else {
                errors_.push_back(
                    {"wrong_type",
                     fmt::format("pass `{}`: \"scale\" wants two whole numbers from 1 to 65536", pass.name),
                     "[1, 2] is half", scale->where});
            }
        }
        if (const Json* size = fields.find("size", Json::Kind::object)) {
            JsonFields inner(*size, fmt::format("pass `{}`: \"size\"", pass.name), errors_);
            if (const Json* of = inner.require("of", Json::Kind::string))
                pass.size_of = NamedPlace{of->string, of->where};
            inner.finish();
        }
    }

    void read_pass(const Json::Member& member)
    {
        GraphDescription::Pass pass;
        pass.name = member.key;
        pass.where = member.where;
        take_name(member.key, member.where);
        const std::string what = fmt::format("pass `{}`", member.key);
        JsonFields fields(member.value, what, errors_);
        if (const Json* name = fields.require("pass", Json::Kind::string))
            pass.pass = {name->string, name->where};
        if (const Json* inputs = fields.find("inputs", Json::Kind::object)) {
            for (const Json::Member& input : inputs->members)
                if (const auto image = text_of(input.value, fmt::format("{}: input `{}`", what, input.key)))
                    pass.inputs.push_back({input.key, *image, input.where});
        }
        read_settings(fields.find("params", Json::Kind::object), pass.settings);
        read_settings(fields.find("choices", Json::Kind::object), pass.settings);
        read_settings(fields.find("rungs", Json::Kind::object), pass.settings);
        read_settings(fields.find("codecs", Json::Kind::object), pass.codecs);
        if (const Json* statics = fields.find("static", Json::Kind::array)) {
            for (const Json& item : statics->array)
                if (const auto name = text_of(item, what + ": \"static\""))
                    pass.statics.emplace_back(name->text, name->where);
        }
        read_size(fields, pass);
        fields.finish();
        graph_.passes.push_back(std::move(pass));
    }

    void read_param(const Json::Member& member)
    {
        GraphParam param{.name = member.key, .places = {}, .where = member.where};
        const std::string what = fmt::format("param `{}`", member.key);
        if (member.value.is(Json::Kind::array)) {
            for (const Json& item : member.value.array)
                if (const auto place = text_of(item, what))
                    param.places.push_back(place->text);
        } else if (const auto place = text_of(member.value, what)) {
            param.places.push_back(place->text);
        }
        graph_.params.push_back(std::move(param));
    }

    GraphDescription graph_;
    Errors errors_;
};

} // namespace

Result<GraphDescription> read_graph_description(std::string_view text, const std::string& file)
{
    const auto json = parse_json(text, file);
    if (!json)
        return tl::unexpected(json.error());
    return Reader(file).read(*json);
}

} // namespace passgraph
