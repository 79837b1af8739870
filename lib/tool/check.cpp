// `passgraph check`: every mistake of a graph or composite file.
#include <filesystem>

#include <fmt/format.h>

#include <passgraph/core/compile.hpp>

#include "tool/commands.hpp"
#include "tool/library.hpp"

namespace passgraph::tool {
namespace {

struct CheckOptions {
    std::string file;
    LibraryOptions library;
};

std::string counted(size_t count, const char* one, const char* many)
{
    return fmt::format("{} {}", count, count == 1 ? one : many);
}

Result<void> check_composite(GraphDescription description, const std::string& file, const PassLibrary& library)
{
    const std::string family = std::filesystem::absolute(file).parent_path().filename().string();
    const Result<PassPtr> pass =
        declare_composite(std::make_shared<const GraphDescription>(std::move(description)), family, library);
    if (!pass)
        return tl::unexpected(pass.error());
    fmt::print("ok: the composite `{}` of {}: {}, {}\n", (*pass)->name, counted((*pass)->composite->passes.size(), "pass", "passes"),
               counted((*pass)->inputs.size(), "input", "inputs"), counted((*pass)->outputs.size(), "output", "outputs"));
    return {};
}

Result<void> check(const CheckOptions& options)
{
    const Result<PassLibrary> library = load_library(options.library);
    if (!library)
        return tl::unexpected(library.error());
    const Result<std::string> text = read_text_file(options.file);
    if (!text)
        return tl::unexpected(text.error());
    Result<GraphDescription> description = read_graph_description(*text, options.file);
    if (!description)
        return tl::unexpected(description.error());
    if (!description->composite_name.empty())
        return check_composite(std::move(*description), options.file, *library);
    const Result<Graph> graph = load_graph(options.file, *library);
    if (!graph)
        return tl::unexpected(graph.error());
    const Result<Plan> plan = compile(*graph);
    if (!plan)
        return tl::unexpected(plan.error());
    fmt::print("ok: {}, {}, {}; {}\n", counted(description->passes.size(), "pass", "passes"),
               counted(description->inputs.size(), "input", "inputs"), counted(description->outputs.size(), "output", "outputs"),
               counted(plan->steps.size(), "step", "steps"));
    return {};
}

} // namespace

void add_check(CommandLine& line)
{
    const auto options = std::make_shared<CheckOptions>();
    Command command = line.add_command("check", "Names every mistake of a graph or composite file");
    command.add_option("GRAPH", options->file, "The graph file").required();
    add_to(command, options->library);
    command.action([options] { return check(*options); });
}

} // namespace passgraph::tool
