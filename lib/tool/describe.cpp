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
    if (options.as_json)
        fmt::print("{}\n", pass_json(**pass));
    else
        fmt::print("{}", pass_page(**pass));
    return {};
}

} // namespace

void add_describe(CommandLine& line)
{
    const auto options = std::make_shared<DescribeOptions>();
    Command command = line.add_command("describe", "Tells everything about one pass");
    command.add_option("PASS", options->pass, "A pass by name, or its .glsl file").required();
    command.add_flag("--json", options->as_json, "As JSON");
    add_to(command, options->library);
    command.action([options] { return describe(*options); });
}

} // namespace passgraph::tool
