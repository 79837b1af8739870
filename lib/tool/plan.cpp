// `passgraph plan`: what the compiler decided, and why.
#include <algorithm>

#include <fmt/format.h>

#include "tool/commands.hpp"
#include "tool/device.hpp"
#include "tool/job.hpp"
#include "tool/library.hpp"
#include "tool/progress.hpp"

namespace passgraph::tool {
namespace {

struct PlanOptions {
    GraphOptions graph;
    LibraryOptions library;
    SourceOptions sources;
    CompilerOptions compiler;
    std::string format = "text";
    bool with_glsl = false;
    bool measures = false;
    DeviceOptions device;
};

double median(std::vector<double> values)
{
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
    return values[values.size() / 2];
}

/// What leaving out saves here: this plan and one that draws everything, frame by frame in turn.
Result<void> print_saving(const Job& job, const Context& context)
{
    const Progress progress("measuring what is saved");
    CompileOptions everything = job.options;
    everything.specialise = false;
    std::vector<Renderer> renderers;
    for (const CompileOptions& options : {job.options, everything}) {
        Result<Renderer> renderer = create_renderer(job, options, {.loader = context.loader(), .is_timed = true});
        if (!renderer)
            return tl::unexpected(renderer.error());
        renderers.push_back(std::move(*renderer));
    }
    constexpr int kWarmUps = 2;
    constexpr int kFrames = 9;
    std::vector<double> frame_ms[2];
    std::vector<StepTime> last;
    for (int frame = 0; frame < kWarmUps + kFrames; ++frame)
        for (size_t i = 0; i < 2; ++i) {
            if (const Result<void> drawn = renderers[i].render({.index = frame, .redraws = true}); !drawn)
                return drawn;
            double sum = 0.0;
            const std::vector<StepTime> times = renderers[i].step_times();
            for (const StepTime& time : times)
                sum += time.milliseconds;
            if (frame >= kWarmUps)
                frame_ms[i].push_back(sum);
            if (i == 0)
                last = times;
        }
    const double needed = median(frame_ms[0]);
    const double all = median(frame_ms[1]);
    fmt::print("saved\n  {:.1f} ms of {:.1f} ms a frame, beside a plan that draws everything, on {}\n", all - needed, all,
               renderers[0].device_name());
    for (size_t i = 0; i < last.size(); ++i)
        if (last[i].was_skipped)
            fmt::print("  {}: {} by the device in this frame\n", last[i].step,
                       renderers[0].plan().steps[i].when_skipped.empty() ? "left out" : "drawn in its simpler variant");
    return {};
}

void print_glsl(const Plan& plan)
{
    for (size_t i = 0; i < plan.steps.size(); ++i) {
        const Plan::Step& step = plan.steps[i];
        for (const auto& [stage, text] : {std::pair{"vertex stage", &step.vertex},
                                          {step.tested_depth_slot < 0 ? "fragment stage" : "fragment stage of surfaces", &step.fragment},
                                          {"fragment stage of the background", &step.background},
                                          {"fragment stage when skipped", &step.when_skipped},
                                          {"fragment stage of the scout", &step.scout}})
            if (!text->empty())
                fmt::print("\n// step {}: {}, {}\n{}", i + 1, step.name, stage, *text);
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
    std::unique_ptr<Context> context;
    Device device = CompileOptions{}.device;
    if (options.measures || !options.device.context.empty()) {
        Result<std::unique_ptr<Context>> opened = open_context(options.device);
        const Result<Device> limits = opened ? query_device((*opened)->loader()) : tl::unexpected(opened.error());
        if (!limits)
            return tl::unexpected(limits.error());
        context = std::move(*opened);
        device = *limits;
    }
    const Result<Job> job = prepare_for(device, std::move(*graph), options.sources, options.compiler, options.measures);
    if (!job)
        return tl::unexpected(job.error());
    if (options.format == "json") {
        fmt::print("{}", to_json(job->plan, options.with_glsl));
        return {};
    }
    fmt::print("{}", options.format == "dot" ? to_dot(job->plan) : to_text(job->plan));
    if (options.with_glsl)
        print_glsl(job->plan);
    return options.measures ? print_saving(*job, *context) : Result<void>{};
}

} // namespace

void add_plan(CommandLine& line)
{
    const auto options = std::make_shared<PlanOptions>();
    Command command = line.add_command("plan", "Shows a graph's compiled plan: for any device, or with --context or --measure for that one");
    add_to(command, options->graph);
    add_to(command, options->sources);
    command.add_option("--format", options->format, "text, json, or dot for Graphviz").one_of({"text", "json", "dot"});
    command.add_flag("--glsl", options->with_glsl, "The generated GLSL, too");
    command.add_flag("--measure", options->measures, "Draws it, too, and says how many milliseconds are saved by what is left out");
    add_to(command, options->library);
    add_to(command, options->compiler);
    add_to(command, options->device);
    command.action([options] { return plan(*options); });
}

} // namespace passgraph::tool
