// `passgraph plan`: what the compiler decided, and why.
#include <fmt/format.h>

#include "tool/commands.hpp"
#include "tool/job.hpp"
#include "tool/library.hpp"

namespace passgraph::tool {
namespace {

struct PlanOptions {
    GraphOptions graph;
    LibraryOptions library;
    SourceOptions sources;
    CompilerOptions compiler;
    std::string format = "text";
    bool with_glsl = false;
};

void print_glsl(const Plan& plan)
{
    for (size_t i = 0; i < plan.steps.size(); ++i) {
        const Plan::Step& step = plan.steps[i];
        fmt::print("\n// step {}: {}, vertex stage\n{}", i + 1, step.name, step.vertex);
        fmt::print("\n// step {}: {}, fragment stage\n{}", i + 1, step.name, step.fragment);
        for (size_t source = 0; source < step.sources.size(); ++source)
            fmt::print("// #line source {}: {}\n", source, step.sources[source]);
    }
}

Result<void> plan(const PlanOptions& options)
{
    const Result<PassLibrary> library = load_library(options.library);
    if (!library)
        return tl::unexpected(library.error());
    Result<Graph> graph = open_graph(options.graph, *library);
    if (!graph)
        return tl::unexpected(graph.error());
    const Result<Job> job = prepare_plan(std::move(*graph), options.sources, options.compiler);
    if (!job)
        return tl::unexpected(job.error());
    if (options.format == "json") {
        fmt::print("{}", to_json(job->plan, options.with_glsl));
        return {};
    }
    fmt::print("{}", options.format == "dot" ? to_dot(job->plan) : to_text(job->plan));
    if (options.with_glsl)
        print_glsl(job->plan);
    return {};
}

} // namespace

void add_plan(CommandLine& line)
{
    const auto options = std::make_shared<PlanOptions>();
    Command command = line.add_command("plan", "Shows a graph's compiled plan; makes no context");
    add_to(command, options->graph);
    add_to(command, options->sources);
    command.add_option("--format", options->format, "text, json, or dot for Graphviz").one_of({"text", "json", "dot"});
    command.add_flag("--glsl", options->with_glsl, "The generated GLSL, too");
    add_to(command, options->library);
    add_to(command, options->compiler);
    command.action([options] { return plan(*options); });
}

} // namespace passgraph::tool
