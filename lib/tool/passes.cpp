// `passgraph passes`: every pass there is.
#include <map>

#include <fmt/format.h>

#include "tool/commands.hpp"
#include "tool/library.hpp"
#include "tool/pass_pages.hpp"

namespace passgraph::tool {
namespace {

struct PassesOptions {
    LibraryOptions library;
    bool as_json = false;
};

Result<void> list_passes(const PassesOptions& options)
{
    const Result<PassLibrary> library = load_library(options.library);
    if (!library)
        return tl::unexpected(library.error());
    if (options.as_json) {
        fmt::print("{}\n", passes_json(*library));
        return {};
    }
    std::map<std::string, std::string> families;
    for (const auto& [name, pass] : library->passes())
        families[pass->family] += pass_entry(*pass);
    for (const auto& [family, entries] : families)
        fmt::print("{}\n{}", family, entries);
    return {};
}

} // namespace

void add_passes(CommandLine& line)
{
    const auto options = std::make_shared<PassesOptions>();
    Command command = line.add_command("passes", "Lists every pass with its ports, parameters, choices and ladders");
    command.add_flag("--json", options->as_json, "As JSON");
    add_to(command, options->library);
    command.action([options] { return list_passes(*options); });
}

} // namespace passgraph::tool
