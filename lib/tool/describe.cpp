// `passgraph describe`: all about one pass.
#include <fmt/format.h>

#include "tool/commands.hpp"
#include "tool/library.hpp"
#include "tool/pass_pages.hpp"

namespace passgraph::tool {
namespace {

struct DescribeOptions {
    std::string pass;
    LibraryOptions library;
    bool as_json = false;
};

Result<void> describe(const DescribeOptions& options)
{
    Result<PassLibrary> library = load_library(options.library);
    if (!library)
        return tl::unexpected(library.error());
    const Result<PassPtr> pass = find_pass(options.pass, *library);
    if (!pass)
        return tl::unexpected(pass.error());
    if (!options.as_json) {
        fmt::print("{}", pass_page(**pass));
        return {};
    }
    nlohmann::ordered_json json = {{"passgraph", 1}};
    json.update(pass_json(**pass));
    fmt::print("{}\n", json_text(json));
    return {};
}

} // namespace

void add_describe(CLI::App& app, Action& chosen)
{
    const auto options = std::make_shared<DescribeOptions>();
    CLI::App& command = *app.add_subcommand("describe", "Tells everything about one pass");
    command.add_option("PASS", options->pass, "A pass by name, or its .glsl file")->required();
    command.add_flag("--json", options->as_json, "As JSON");
    add_to(command, options->library);
    command.callback([options, &chosen] { chosen = [options] { return describe(*options); }; });
}

} // namespace passgraph::tool
