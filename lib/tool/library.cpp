// Loads passes and graphs by name or path.
#include "tool/library.hpp"

#include <filesystem>

#include <fmt/format.h>

#include <passgraph/shader/pass_file.hpp>

#include "tool/preset.hpp"

namespace passgraph::tool {
namespace {

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
