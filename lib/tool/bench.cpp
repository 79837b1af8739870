// `passgraph bench`: what a frame and each of its steps cost.
#include <algorithm>
#include <chrono>
#include <optional>

#include <fmt/format.h>

#include <passgraph/core/json_value.hpp>

#include "tool/commands.hpp"
#include "tool/device.hpp"
#include "tool/job.hpp"
#include "tool/library.hpp"
#include "tool/progress.hpp"

namespace passgraph::tool {
namespace {

constexpr int kFewestWarmUps = 3; // the first frame compiles; the second may still fill caches
constexpr int kMostWarmUps = 20;
constexpr double kStable = 0.1; // two frames in a row within 10 %

struct BenchOptions {
    GraphOptions graph;
    LibraryOptions library;
    SourceOptions sources;
    CompilerOptions compiler;
    DeviceOptions device;
    std::string compared; ///< steps that the second plan leaves out
    int frames = 20;
    bool as_json = false;
};

double median(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    const size_t middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

/// A plan being timed.
struct Timed {
    Renderer renderer;
    int frame = 0;
    std::vector<double> frame_ms{};
    std::vector<std::vector<double>> step_ms{}; ///< by step, then by frame
    std::vector<StepTime> last{};               ///< of the last frame

    double median_ms() const { return median(frame_ms); }
    double lowest_ms() const { return *std::min_element(frame_ms.begin(), frame_ms.end()); }
};

/// Draws one frame to its end. Returns its milliseconds on the wall clock.
Result<double> draw(Timed& timed, bool is_kept)
{
    const auto start = std::chrono::steady_clock::now();
    if (const Result<void> drawn = timed.renderer.render({.time = timed.frame / 60.0, .index = timed.frame, .redraws = true}); !drawn)
        return tl::unexpected(drawn.error());
    const std::vector<StepTime> steps = timed.renderer.step_times(); // waits for the frame to finish
    const double ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    ++timed.frame;
    if (!is_kept)
        return ms;
    timed.frame_ms.push_back(ms);
    timed.step_ms.resize(steps.size());
    for (size_t i = 0; i < steps.size(); ++i)
        timed.step_ms[i].push_back(steps[i].milliseconds);
    timed.last = steps;
    return ms;
}

Result<void> warm_up(Timed& timed)
{
    double before = 0.0;
    for (int i = 0; i < kMostWarmUps; ++i) {
        const Result<double> now = draw(timed, false);
        if (!now)
            return tl::unexpected(now.error());
        if (i + 1 >= kFewestWarmUps && std::abs(*now - before) <= kStable * before)
            break;
        before = *now;
    }
    return {};
}

Result<Timed> start(const Job& job, const CompileOptions& options, GlLoader loader)
{
    Result<Renderer> renderer = create_renderer(job, options, {.loader = loader, .is_timed = true});
    if (!renderer)
        return tl::unexpected(renderer.error());
    Timed timed{.renderer = std::move(*renderer)};
    if (const Result<void> warm = warm_up(timed); !warm)
        return tl::unexpected(warm.error());
    return timed;
}

/// The plans take turns, so that a machine's drift meets all alike.
Result<void> measure(std::vector<Timed>& plans, int frames)
{
    Progress progress(fmt::format("timing {} frames", frames));
    for (int frame = 0; frame < frames; ++frame) {
        for (Timed& timed : plans)
            if (const Result<double> ms = draw(timed, true); !ms)
                return tl::unexpected(ms.error());
        progress.update(fmt::format("frame {} of {}", frame + 1, frames));
    }
    return {};
}

void print_text(const std::vector<Timed>& plans, const BenchOptions& options)
{
    const Timed& first = plans.front();
    const Plan& plan = first.renderer.plan();
    fmt::print("{}\n{}x{}, {} frames, {:.1f} MB of images\n\n", first.renderer.device_name(), plan.extent.width, plan.extent.height,
               options.frames, static_cast<double>(plan.bytes) / (1024.0 * 1024.0));
    for (size_t i = 0; i < first.step_ms.size(); ++i) {
        const std::string why = why_skipped(plan, i, first.last[i].was_skipped);
        fmt::print("{:9.3f} ms  {}{}\n", median(first.step_ms[i]), plan.steps[i].name, why.empty() ? "" : fmt::format("  ({})", why));
    }
    fmt::print("{:9.3f} ms  the frame (lowest {:.3f})\n", first.median_ms(), first.lowest_ms());
    if (plans.size() > 1)
        fmt::print("{:9.3f} ms  the frame without {}: this plan takes {:.3f} of it\n", plans[1].median_ms(), options.compared,
                   first.median_ms() / plans[1].median_ms());
}

void print_json(const std::vector<Timed>& plans, const BenchOptions& options)
{
    using Object = JsonValue;
    const Timed& first = plans.front();
    const Plan& plan = first.renderer.plan();
    const auto frame_json = [](const Timed& timed) { return Object{{"median", timed.median_ms()}, {"lowest", timed.lowest_ms()}}; };
    Object json = {{"passgraph", 1},
                   {"device", first.renderer.device_name()},
                   {"size", Object::array({plan.extent.width, plan.extent.height})},
                   {"frames", options.frames},
                   {"frame_ms", frame_json(first)},
                   {"steps", Object::array()},
                   {"bytes", plan.bytes}};
    for (size_t i = 0; i < first.step_ms.size(); ++i)
        json["steps"].push_back({{"name", plan.steps[i].name}, {"ms", median(first.step_ms[i])}, {"skipped", first.last[i].was_skipped}});
    if (plans.size() > 1)
        json["compared"] = {{"off", options.compared}, {"frame_ms", frame_json(plans[1])}, {"ratio", first.median_ms() / plans[1].median_ms()}};
    fmt::print("{}\n", json.text(2));
}

Result<void> bench(const BenchOptions& options)
{
    const Result<PassLibrary> library = load_library(options.library);
    if (!library)
        return tl::unexpected(library.error());
    Result<Graph> graph = open_graph(options.graph, *library);
    if (!graph)
        return tl::unexpected(graph.error());
    const Result<Job> job = prepare(std::move(*graph), options.sources, options.compiler);
    if (!job)
        return tl::unexpected(job.error());
    const Result<std::unique_ptr<Context>> context = open_context(options.device);
    if (!context)
        return tl::unexpected(context.error());
    std::vector<CompileOptions> variants = {job->options};
    if (!options.compared.empty()) {
        variants.push_back(job->options);
        CompilerOptions{options.compared}.apply_to(variants.back());
    }
    std::vector<Timed> plans;
    for (const CompileOptions& variant : variants) {
        Result<Timed> timed = start(*job, variant, (*context)->loader());
        if (!timed)
            return tl::unexpected(timed.error());
        plans.push_back(std::move(*timed));
    }
    if (Result<void> measured = measure(plans, options.frames); !measured)
        return measured;
    if (options.as_json)
        print_json(plans, options);
    else
        print_text(plans, options);
    return {};
}

} // namespace

void add_bench(CommandLine& line)
{
    const auto options = std::make_shared<BenchOptions>();
    Command command = line.add_command("bench", "Times a graph's frame and its steps");
    add_to(command, options->graph);
    add_to(command, options->sources);
    command.add_option("--frames", options->frames, "Frames to time, after warming up").positive().type_name("N");
    add_steps(command, "--compare-off", options->compared, "Times a second plan without these steps, frame by frame in turn");
    command.add_flag("--json", options->as_json, "As JSON");
    add_to(command, options->library);
    add_to(command, options->compiler);
    add_to(command, options->device);
    command.action([options] { return bench(*options); });
}

} // namespace passgraph::tool
