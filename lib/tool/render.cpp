// `passgraph render`: draws a graph into files.
#include "tool/commands.hpp"
#include "tool/device.hpp"
#include "tool/job.hpp"
#include "tool/library.hpp"
#include "tool/outputs.hpp"

namespace passgraph::tool {
namespace {

struct RenderOptions {
    GraphOptions graph;
    LibraryOptions library;
    SourceOptions sources;
    CompilerOptions compiler;
    DeviceOptions device;
    std::vector<std::string> outputs;
    int frames = 1;
};

Result<void> render(const RenderOptions& options)
{
    const Result<PassLibrary> library = load_library(options.library);
    if (!library)
        return tl::unexpected(library.error());
    Result<Graph> graph = open_graph(options.graph, *library);
    if (!graph)
        return tl::unexpected(graph.error());
    const std::vector<OutputFile> outputs = name_outputs(*graph, options.outputs);
    const Result<Job> job = prepare(std::move(*graph), options.sources, options.compiler);
    if (!job)
        return tl::unexpected(job.error());
    if (Result<void> checked = check_outputs(job->plan, outputs); !checked)
        return checked;
    const Result<std::unique_ptr<Context>> context = open_context(options.device);
    if (!context)
        return tl::unexpected(context.error());
    Result<Renderer> renderer = create_renderer(*job, job->options, {.loader = (*context)->loader()});
    if (!renderer)
        return tl::unexpected(renderer.error());
    return render_frames(*renderer, options.frames, outputs);
}

} // namespace

void add_render(CommandLine& line)
{
    const auto options = std::make_shared<RenderOptions>();
    Command command = line.add_command("render", "Draws a graph into files");
    add_to(command, options->graph);
    add_to(command, options->sources);
    command.add_option("--frames", options->frames, "Runs N frames, 1/60 s apart, and writes the last")
        .positive()
        .type_name("N");
    add_pairs(command, "--out", options->outputs,
              "Writes an output, or any PASS.PORT; %04d in the file's name writes every frame")
        .required()
        .type_name("NAME=FILE");
    add_to(command, options->library);
    add_to(command, options->compiler);
    add_to(command, options->device);
    command.action([options] { return render(*options); });
}

} // namespace passgraph::tool
