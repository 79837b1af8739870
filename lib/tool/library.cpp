// Loads passes and graphs by name or path.
#include "tool/library.hpp"

#include <filesystem>
#include <optional>

#include <fmt/format.h>

#include <passgraph/shader/pass_file.hpp>

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

void set_all(Graph& graph, const std::vector<PassArguments::Setting>& settings)
{
    for (const PassArguments::Setting& setting : settings)
        if (const Result<void> set = graph.set(setting.name, setting); !set)
            for (const Error& error : set.error())
                graph.report(error);
}

} // namespace

std::string common_folder() { return PASSGRAPH_COMMON_FOLDER; }

Result<PassLibrary> load_library(const LibraryOptions& options)
{
    PassLibrary library = builtin_passes();
    Errors errors;
    for (const std::string& folder : options.folders) {
        std::error_code failed;
        if (!std::filesystem::is_directory(folder, failed))
            errors.push_back({.code = "file_missing",
                              .message = fmt::format("there is no folder `{}`", folder),
                              .hint = "--passes names a folder with .glsl files"});
        else if (const Result<void> loaded = load_pass_folder(folder, library, common_folder()); !loaded)
            append(errors, loaded.error());
    }
    if (!errors.empty())
        return tl::unexpected(std::move(errors));
    return library;
}

Result<PassPtr> find_pass(const std::string& name_or_file, PassLibrary& library)
{
    if (name_or_file.ends_with(".glsl")) {
        Result<PassPtr> pass = load_pass_file(name_or_file, common_folder());
        if (pass)
            library.add(*pass);
        return pass;
    }
    if (PassPtr pass = library.find(name_or_file))
        return pass;
    return fail({.code = "unknown_pass",
                 .message = fmt::format("there is no pass `{}`", name_or_file),
                 .hint = suggest(name_or_file, library.names(), "passes")});
}

Result<Graph> open_graph(const GraphOptions& options, const PassLibrary& library)
{
    Result<Graph> graph = load_graph(options.file, library);
    Result<std::vector<PassArguments::Setting>> preset;
    if (!options.preset.empty())
        preset = read_preset(options.preset);
    Errors errors;
    if (!graph)
        append(errors, graph.error());
    if (!preset)
        append(errors, preset.error());
    if (!errors.empty())
        return tl::unexpected(std::move(errors));
    set_all(*graph, *preset);
    std::vector<PassArguments::Setting> settings;
    for (const Pair& pair : pairs_of("--set", options.settings))
        settings.push_back(setting_of(pair));
    set_all(*graph, settings);
    return graph;
}

} // namespace passgraph::tool
