// `passgraph prove`: what is left out changes nothing.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <set>

#include <fmt/format.h>

#include <passgraph/core/json_value.hpp>
#include <passgraph/image/image_file.hpp>

#include "tool/commands.hpp"
#include "tool/device.hpp"
#include "tool/job.hpp"
#include "tool/library.hpp"
#include "tool/progress.hpp"

namespace passgraph::tool {
namespace {

struct ProveOptions {
    GraphOptions graph;
    LibraryOptions library;
    SourceOptions sources;
    CompilerOptions compiler;
    DeviceOptions device;
    bool is_json = false;
};

/// A frame, and how it was drawn.
struct Drawing {
    Plan plan;
    std::map<std::string, Picture> outputs;
    int steps_skipped = 0;    ///< that the device left out
    int passes_skipped = 0;   ///< of those steps
    int simpler = 0;          ///< steps drawn in their variant for what is black
    bool answers_all = true;  ///< every query counted nothing
};

Result<Drawing> draw(const Job& job, const CompileOptions& options, GlLoader loader)
{
    Result<Renderer> renderer = create_renderer(job, options, {.loader = loader, .is_timed = true});
    if (!renderer)
        return tl::unexpected(renderer.error());
    for (const bool is_second : {false, true}) // the first frame has none before it from which scouts could be sent out
        if (const Result<void> drawn = renderer->render({.redraws = is_second}); !drawn)
            return tl::unexpected(drawn.error());
    Drawing drawing{.plan = renderer->plan(), .outputs = {}};
    const std::vector<StepTime> times = renderer->step_times();
    for (size_t i = 0; i < times.size(); ++i) {
        const Plan::Step& step = drawing.plan.steps[i];
        const bool is_variant = !step.when_skipped.empty();
        drawing.simpler += times[i].was_skipped && is_variant;
        drawing.steps_skipped += times[i].was_skipped && !is_variant;
        drawing.passes_skipped += times[i].was_skipped && !is_variant ? static_cast<int>(step.passes.size()) : 0;
        drawing.answers_all = drawing.answers_all && (step.skipped_by < 0 || times[i].was_skipped);
    }
    for (const Plan::Output& output : drawing.plan.outputs) {
        Result<Picture> picture = renderer->read(output.name);
        if (!picture)
            return tl::unexpected(picture.error());
        drawing.outputs[output.name] = std::move(*picture);
    }
    return drawing;
}

/// The first texel in which two pictures differ, in the rows' order, and how many do.
struct Difference {
    int texels = 0;
    double largest = 0.0;
    std::string first{};
};

std::string texel_text(const Picture& picture, int x, int y)
{
    std::string text;
    for (int c = 0; c < picture.channels; ++c)
        text += fmt::format("{}{:.9g}", c > 0 ? " " : "", picture.at(x, y, c));
    return text;
}

Difference compare(const Drawing& a, const Drawing& b, std::string_view name_a, std::string_view name_b)
{
    Difference difference;
    for (const auto& [name, one] : a.outputs) {
        const Picture& other = b.outputs.at(name);
        for (int y = 0; y < one.extent.height; ++y)
            for (int x = 0; x < one.extent.width; ++x) {
                const float* from = &one.texels[one.index(x, y)];
                const float* to = &other.texels[other.index(x, y)];
                if (std::memcmp(from, to, sizeof(float) * static_cast<size_t>(one.channels)) == 0)
                    continue;
                if (difference.texels++ == 0)
                    difference.first = fmt::format("{} at ({}, {}): {} {}, {} {}", name, x, y, name_a, texel_text(one, x, y), name_b,
                                                   texel_text(other, x, y));
                for (int c = 0; c < one.channels; ++c)
                    difference.largest = std::max(difference.largest, std::abs(static_cast<double>(from[c]) - static_cast<double>(to[c])));
            }
    }
    return difference;
}

/// The value that storing leaves of it in its signal's default codec, so that storing it once more or once less is the same.
float stored(float value, Signal signal)
{
    if (info(signal).guard != Guard::zero_to_cap || !(value > 0.0f))
        return value;
    const float limited = std::min(value, info(signal).cap);
    if (info(signal).cap <= 1.0f)
        return std::round(limited * 255.0f) / 255.0f;
    if (limited < 6.103515625e-5f) // below the smallest normal half: steps of 2^-24
        return std::trunc(limited * 16777216.0f) / 16777216.0f;
    return std::bit_cast<float>(std::bit_cast<std::uint32_t>(limited) & ~std::uint32_t{0x1fff});
}

void round_pictures(Job& job)
{
    for (const Plan::Import& import : job.plan.imports) {
        const auto picture = job.sources.pictures.find(import.name);
        if (picture == job.sources.pictures.end())
            continue;
        picture->second = resized(picture->second, import.extent);
        for (float& value : picture->second.texels)
            value = stored(value, import.signal);
    }
}

int pass_count(const Plan& plan)
{
    int count = 0;
    for (const Plan::Step& step : plan.steps)
        count += static_cast<int>(step.passes.size());
    return count;
}

struct Promise {
    std::string text;
    bool holds = true;
    std::string account; ///< what was found
};

std::string difference_text(const Difference& difference)
{
    return difference.texels == 0 ? "equal, bit for bit"
                                  : fmt::format("{} texels differ, by {:.3g} at most; first {}", difference.texels, difference.largest,
                                                difference.first);
}

/// What a frame owes its graph, with each pass drawn by itself, so that every image is rounded alike.
struct Proof {
    Drawing automatic;
    Drawing on;
    Drawing off;
    Drawing as_drawn; ///< fused, as everybody draws it
    Drawing as_drawn_on;
    std::vector<Promise> promises{};
    std::string needed{}; ///< what the picture would be without what may be skipped
    std::string fused{};  ///< by how much fusion rounds otherwise

    bool holds() const { return std::all_of(promises.begin(), promises.end(), [](const Promise& p) { return p.holds; }); }
};

void judge(Proof& proof)
{
    const Difference on = compare(proof.automatic, proof.on, "auto", "forced on");
    proof.promises.push_back({"auto is what everything drawn gives", on.texels == 0, difference_text(on)});
    const Difference off = compare(proof.automatic, proof.off, "auto", "forced off");
    if (proof.automatic.answers_all)
        proof.promises.push_back({"auto is what nothing drawn gives, as nothing that may be skipped was drawn", off.texels == 0, difference_text(off)});
    proof.needed = difference_text(off);
    const Difference drawn = compare(proof.as_drawn, proof.as_drawn_on, "auto", "forced on");
    proof.fused = difference_text(drawn);
}

int left_out_before(const Proof& proof) { return pass_count(proof.on.plan) - pass_count(proof.automatic.plan); }

void print_text(const Proof& proof)
{
    for (const Promise& promise : proof.promises)
        fmt::print("{}  {}: {}\n", promise.holds ? "holds " : "BROKEN", promise.text, promise.account);
    fmt::print("forced off   {}\n", proof.automatic.answers_all ? "the same" : proof.needed);
    fmt::print("as drawn     {} between auto and forced on, fused\n", proof.fused);
    fmt::print("left out     {} of {} passes: {} before drawing, {} by the device; {} drawn in a simpler variant\n",
               std::max(left_out_before(proof), 0) + proof.automatic.passes_skipped, pass_count(proof.on.plan), std::max(left_out_before(proof), 0),
               proof.automatic.passes_skipped, proof.automatic.simpler);
    for (const Plan::Decision& decision : proof.automatic.plan.decisions)
        fmt::print("  {}: {}\n", decision.what, decision.reason);
}

void print_json(const Proof& proof)
{
    JsonValue json = {{"passgraph", 1}, {"holds", proof.holds()}, {"promises", JsonValue::array()}};
    for (const Promise& promise : proof.promises)
        json["promises"].push_back({{"promise", promise.text}, {"holds", promise.holds}, {"account", promise.account}});
    json["passes"] = pass_count(proof.on.plan);
    json["left_out_before_drawing"] = std::max(left_out_before(proof), 0);
    json["left_out_by_the_device"] = proof.automatic.passes_skipped;
    json["simpler_variants"] = proof.automatic.simpler;
    json["forced_off"] = proof.needed;
    json["as_drawn"] = proof.fused;
    json["decisions"] = JsonValue::array();
    for (const Plan::Decision& decision : proof.automatic.plan.decisions)
        json["decisions"].push_back({{"what", decision.what}, {"reason", decision.reason}});
    fmt::print("{}\n", json.text(2));
}

Result<Proof> draw_all(const Job& job, GlLoader loader)
{
    Proof proof;
    Errors errors;
    const auto take = [&](Drawing& into, bool fuses, bool specialises, Skipping skipping) {
        CompileOptions options = job.options;
        options.fuse = fuses && options.fuse;
        options.specialise = specialises;
        options.skipping = skipping;
        Result<Drawing> drawing = draw(job, options, loader);
        if (drawing)
            into = std::move(*drawing);
        else if (errors.empty())
            errors = drawing.error();
    };
    Progress progress("drawing with everything");
    take(proof.on, false, false, Skipping::never);
    progress.update("drawing what is called for");
    take(proof.automatic, false, true, Skipping::as_needed);
    progress.update("drawing without what may be skipped");
    take(proof.off, false, true, Skipping::always);
    progress.update("drawing fused");
    take(proof.as_drawn, true, true, Skipping::as_needed);
    take(proof.as_drawn_on, true, false, Skipping::never);
    if (!errors.empty())
        return tl::unexpected(std::move(errors));
    judge(proof);
    return proof;
}

Result<void> prove(const ProveOptions& options)
{
    const Result<PassLibrary> library = load_library(options.library);
    if (!library)
        return tl::unexpected(library.error());
    Result<Graph> graph = open_graph(options.graph, *library);
    if (!graph)
        return tl::unexpected(graph.error());
    Result<Job> job = prepare(std::move(*graph), options.sources, options.compiler);
    if (!job)
        return tl::unexpected(job.error());
    round_pictures(*job);
    const Result<std::unique_ptr<Context>> context = open_context(options.device);
    if (!context)
        return tl::unexpected(context.error());
    const Result<Proof> proof = draw_all(*job, (*context)->loader());
    if (!proof)
        return tl::unexpected(proof.error());
    options.is_json ? print_json(*proof) : print_text(*proof);
    if (proof->holds())
        return {};
    return fail({.code = "promise_broken",
                 .message = "what was left out is missed",
                 .hint = "a header's \"identity\", \"black\", \"skip\", \"bound\", \"ignores\", \"needs\" or \"only_where\" says more than is true; "
                         "`passgraph test` checks them one by one"});
}

} // namespace

void add_prove(CommandLine& line)
{
    const auto options = std::make_shared<ProveOptions>();
    Command command = line.add_command("prove", "Draws a graph as it is called for, with everything and with nothing that may be skipped, and compares");
    add_to(command, options->graph);
    add_to(command, options->sources);
    command.add_flag("--json", options->is_json, "As a JSON object");
    add_to(command, options->library);
    add_to(command, options->compiler);
    add_to(command, options->device);
    command.footer("Exit code 1 when a promise is broken. Pictures are rounded as storing rounds them, first.");
    command.action([options] { return prove(*options); });
}

} // namespace passgraph::tool
