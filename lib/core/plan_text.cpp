// The plan as people read it: steps, memory, boundaries with their reasons; and as a Graphviz digraph.
#include <algorithm>

#include <fmt/format.h>

#include "passgraph/core/plan.hpp"

namespace passgraph {
namespace {

double megabytes(std::int64_t bytes) { return static_cast<double>(bytes) / (1024.0 * 1024.0); }

std::string slot_text(const Plan& plan, int slot)
{
    return fmt::format("slot {} {}", slot, name(plan.slots[static_cast<size_t>(slot)].format));
}

std::string read_text(const Plan::Read& read)
{
    const std::string where = read.source == Plan::Read::Source::slot ? fmt::format("slot {}", read.index) : "import";
    return fmt::format("{} ({}, {})", read.image, where, read.is_loaded ? "loaded" : read.filter == Filter::linear ? "linear" : "nearest");
}

/// How many steps a change of what step `changed` computes redraws: itself, and every later step that reads its images.
int redrawn_steps(const Plan& plan, size_t changed)
{
    std::vector<bool> is_new(plan.slots.size(), false); // by slot: does it hold an image that changed?
    int count = 0;
    for (size_t i = changed; i < plan.steps.size(); ++i) {
        const Plan::Step& step = plan.steps[i];
        const bool is_redrawn =
            i == changed || std::any_of(step.reads.begin(), step.reads.end(), [&](const Plan::Read& read) {
                return read.source == Plan::Read::Source::slot && is_new[static_cast<size_t>(read.index)];
            });
        count += is_redrawn;
        for (const int slot : step.written_slots())
            is_new[static_cast<size_t>(slot)] = is_redrawn;
    }
    return count;
}

const std::string& images_of(const Plan& plan, int query) { return plan.queries[static_cast<size_t>(query)].images; }

void add_step(std::string& text, const Plan& plan, size_t index)
{
    const Plan::Step& step = plan.steps[index];
    text += fmt::format("  {}. {}  {}x{}{}\n", index + 1, step.name, step.extent.width, step.extent.height,
                        step.kind == Plan::Step::Kind::geometry ? "  geometry" : "");
    for (const Plan::Read& read : step.reads)
        text += fmt::format("       reads   {}\n", read_text(read));
    for (const Plan::Target& target : step.targets)
        text += fmt::format("       writes  {} ({})\n", target.image, slot_text(plan, target.slot));
    if (step.depth_slot >= 0)
        text += fmt::format("       depth   {}\n", slot_text(plan, step.depth_slot));
    if (step.tested_depth_slot >= 0)
        text += fmt::format("       parts   surfaces, and {}, by the depth in {}\n",
                            step.background.empty() ? "a background that is cleared to black" : "background",
                            slot_text(plan, step.tested_depth_slot));
    if (step.counts >= 0)
        text += fmt::format("       asks    is any pixel of {} not black? (the device answers, the frame goes on)\n",
                            images_of(plan, step.counts));
    if (!step.scout.empty())
        text += fmt::format("       scouts  after a frame without any, {}x{} pixels look first whether there is anything to draw\n",
                            step.scout_extent.width, step.scout_extent.height);
    if (step.skipped_by >= 0)
        text += step.when_skipped.empty()
                    ? fmt::format("       runs    only if {} has a pixel that is not black; else it is black too\n",
                                  images_of(plan, step.skipped_by))
                    : fmt::format("       variant without {}, unless {} has a pixel that is not black\n", step.black_images,
                                  images_of(plan, step.skipped_by));
    for (const Plan::Uniform& uniform : step.uniforms)
        text += fmt::format("       live    {}: a change concerns {} of {} steps\n", uniform.place,
                            redrawn_steps(plan, index), plan.steps.size());
}

std::string quoted(std::string_view text)
{
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\')
            out += '\\';
        out += c;
    }
    return out + "\"";
}

} // namespace

std::string to_text(const Plan& plan)
{
    std::string text = fmt::format("plan for {}x{}: {} steps, {} slots, {:.1f} MB ({:.1f} MB without sharing)\n",
                                   plan.extent.width, plan.extent.height, plan.steps.size(), plan.slots.size(),
                                   megabytes(plan.bytes), megabytes(plan.bytes_unshared));
    text += "steps\n";
    for (size_t i = 0; i < plan.steps.size(); ++i)
        add_step(text, plan, i);
    text += "slots\n";
    for (size_t i = 0; i < plan.slots.size(); ++i) {
        const Plan::Slot& slot = plan.slots[i];
        text += fmt::format("  {}. {} {}x{}  {}\n", i, name(slot.format), slot.extent.width, slot.extent.height,
                            fmt::join(slot.images, ", then "));
    }
    if (!plan.inlined.empty())
        text += fmt::format("kept in registers\n  {}\n", fmt::join(plan.inlined, ", "));
    if (!plan.boundaries.empty())
        text += "kept in memory, because\n";
    for (const Plan::Boundary& boundary : plan.boundaries)
        text += fmt::format("  {} -> {}: {}\n", boundary.image, boundary.reader, boundary.reason);
    if (!plan.culled.empty())
        text += "not run\n";
    for (const Plan::Culled& culled : plan.culled)
        text += fmt::format("  {}: {}\n", culled.pass, culled.reason);
    std::string decisions;
    for (const Plan::Decision& decision : plan.decisions)
        if (std::none_of(plan.culled.begin(), plan.culled.end(), [&](const Plan::Culled& culled) { return culled.pass == decision.what; }))
            decisions += fmt::format("  {}: {}\n", decision.what, decision.reason);
    if (!decisions.empty())
        text += "not needed here\n" + decisions;
    text += "outputs\n";
    for (const Plan::Output& output : plan.outputs)
        text += fmt::format("  {}: {} as {} {}, {}x{}\n", output.name, output.image, info(output.signal).name,
                            output.codec.name, output.extent.width, output.extent.height);
    return text;
}

std::string to_dot(const Plan& plan)
{
    std::string text = "digraph plan {\n  rankdir=LR;\n  node [shape=box, fontname=\"sans-serif\"];\n";
    for (size_t i = 0; i < plan.imports.size(); ++i)
        text += fmt::format("  import{} [label={}, shape=ellipse];\n", i, quoted(plan.imports[i].name));
    for (size_t i = 0; i < plan.steps.size(); ++i) {
        const bool may_be_left_out = plan.steps[i].skipped_by >= 0 && plan.steps[i].when_skipped.empty();
        text += fmt::format("  step{} [label={}{}];\n", i, quoted(fmt::format("{}. {}", i + 1, plan.steps[i].name)),
                            may_be_left_out ? ", style=dashed" : "");
    }
    for (size_t i = 0; i < plan.steps.size(); ++i)
        if (const Plan::Step& step = plan.steps[i]; step.skipped_by >= 0)
            text += fmt::format("  step{} -> step{} [label={}, style=dashed];\n",
                                plan.queries[static_cast<size_t>(step.skipped_by)].step, i,
                                quoted(step.when_skipped.empty() ? "only if not black" : "simpler if black"));
    for (size_t reader = 0; reader < plan.steps.size(); ++reader) {
        for (const Plan::Read& read : plan.steps[reader].reads) {
            if (read.source == Plan::Read::Source::import) {
                text += fmt::format("  import{} -> step{} [label={}];\n", read.index, reader, quoted(read.image));
                continue;
            }
            for (size_t writer = reader; writer-- > 0;) {
                if (!plan.steps[writer].writes(read.index))
                    continue;
                text += fmt::format("  step{} -> step{} [label={}];\n", writer, reader, quoted(read.image));
                break;
            }
        }
    }
    for (size_t i = 0; i < plan.outputs.size(); ++i) {
        text += fmt::format("  output{} [label={}, shape=ellipse];\n", i, quoted(plan.outputs[i].name));
        for (size_t writer = plan.steps.size(); writer-- > 0;) {
            if (!plan.steps[writer].writes(plan.outputs[i].index))
                continue;
            text += fmt::format("  step{} -> output{};\n", writer, i);
            break;
        }
    }
    return text + "}\n";
}

} // namespace passgraph
