// Which steps of a plan must run.
#include "gl/freshness.hpp"

#include <algorithm>
#include <string_view>

namespace passgraph::gl {
namespace {

/// The last step before `reader` that draws into the slot; -1: none.
int producer_of(const Plan& plan, int slot, size_t reader)
{
    for (size_t i = reader; i-- > 0;)
        if (plan.steps[i].writes(slot))
            return static_cast<int>(i);
    return -1;
}

/// Nothing that it depends on can change.
bool is_constant(const Plan::Step& step)
{
    const Reads& host = step.host;
    return step.kind == Plan::Step::Kind::draw && step.reads.empty() && step.uniforms.empty() && !host.camera &&
           !host.lights && !host.frame && !host.elements;
}

} // namespace

/// Steele, Lea and Flood 2014, "Fast splittable pseudorandom number generators": a mixer without fixed pattern.
std::uint64_t mixed(std::uint64_t hash, std::uint64_t value)
{
    hash += 0x9e3779b97f4a7c15u + value;
    hash = (hash ^ (hash >> 30)) * 0xbf58476d1ce4e5b9u;
    hash = (hash ^ (hash >> 27)) * 0x94d049bb133111ebu;
    return hash ^ (hash >> 31);
}

namespace {

std::uint64_t hash_of(std::string_view text)
{
    std::uint64_t hash = text.size();
    for (const char c : text)
        hash = mixed(hash, static_cast<std::uint64_t>(static_cast<unsigned char>(c)));
    return hash;
}

/// What a step draws, but for the images it reads and its live values.
std::uint64_t content_of(const Plan& plan, const Plan::Step& step)
{
    std::uint64_t hash = static_cast<std::uint64_t>(step.kind);
    const auto add = [&](auto value) { hash = mixed(hash, static_cast<std::uint64_t>(value)); };
    for (const std::string* text : {&step.vertex, &step.fragment, &step.background})
        add(hash_of(*text));
    // Left out and not cleared, its texture holds anything: no image for a plan in which somebody looks at it.
    add(step.skipped_by >= 0 && step.when_skipped.empty() && !step.is_cleared);
    add(plan.extent.width); // the camera's picture
    add(plan.extent.height);
    for (const int slot : step.written_slots()) {
        const Plan::Slot& row = plan.slots[static_cast<size_t>(slot)];
        add(row.format);
        add(row.extent.width);
        add(row.extent.height);
    }
    for (const Plan::Read& read : step.reads) {
        add(read.source);
        add(read.filter);
        add(read.wrap);
        add(read.has_levels);
        add(hash_of(read.sampler));
        if (read.source == Plan::Read::Source::import)
            add(hash_of(plan.imports[static_cast<size_t>(read.index)].name));
    }
    for (const Plan::Uniform& uniform : step.uniforms)
        add(hash_of(uniform.name));
    return hash;
}

/// The image in the `position`th of the slots that a step draws into.
std::uint64_t image_of(std::uint64_t step, size_t position) { return mixed(step, position + 1); }

/// Which of the slots of its producer a read means.
size_t position_of(const Plan::Step& producer, int slot)
{
    const std::vector<int> slots = producer.written_slots();
    return static_cast<size_t>(std::find(slots.begin(), slots.end(), slot) - slots.begin());
}

} // namespace

Freshness::Freshness(const Plan& plan)
    : held_(plan.slots.size(), 0), counted_(plan.queries.size(), 0), wanted_(plan.steps.size(), 0)
{
    for (size_t i = 0; i < plan.steps.size(); ++i) {
        content_.push_back(content_of(plan, plan.steps[i]));
        std::vector<int>& producers = producers_.emplace_back();
        for (const Plan::Read& read : plan.steps[i].reads)
            producers.push_back(read.source == Plan::Read::Source::slot ? producer_of(plan, read.index, i) : -1);
    }
}

void Freshness::find_wanted(const Plan& plan, const Versions& versions)
{
    for (size_t i = 0; i < plan.steps.size(); ++i) {
        const Plan::Step& step = plan.steps[i];
        std::uint64_t& wanted = wanted_[i] = mixed(content_[i], versions.params[i]);
        if (step.host.camera || step.host.lights || step.host.elements)
            wanted = mixed(mixed(wanted, versions.camera), versions.scene);
        if (step.host.frame)
            wanted = mixed(wanted, versions.frame);
        for (size_t r = 0; r < step.reads.size(); ++r) {
            const int producer = producers_[i][r];
            if (producer >= 0)
                wanted = mixed(wanted, image_of(wanted_[static_cast<size_t>(producer)],
                                                position_of(plan.steps[static_cast<size_t>(producer)], step.reads[r].index)));
            else if (step.reads[r].source == Plan::Read::Source::import)
                wanted = mixed(wanted, versions.imports[static_cast<size_t>(step.reads[r].index)]);
        }
    }
}

std::vector<bool> Freshness::stale(const Plan& plan, const Versions& versions, bool redraws)
{
    const size_t count = plan.steps.size();
    find_wanted(plan, versions);
    const auto holds_it = [&](size_t i) {
        const std::vector<int> slots = plan.steps[i].written_slots();
        bool holds = true;
        for (size_t k = 0; k < slots.size(); ++k)
            holds = holds && held_[static_cast<size_t>(slots[k])] == image_of(wanted_[i], k);
        return holds;
    };
    std::vector<bool> runs(count, false);
    for (size_t i = 0; redraws && i < count; ++i)
        runs[i] = !is_constant(plan.steps[i]) || !holds_it(i);
    for (const Plan::Output& output : plan.outputs)
        if (const int producer = producer_of(plan, output.index, count);
            output.source == Plan::Read::Source::slot && producer >= 0 && !holds_it(static_cast<size_t>(producer)))
            runs[static_cast<size_t>(producer)] = true;
    // A step that runs needs what it reads: held, and not overwritten by a step that runs in between.
    bool is_changed = true;
    while (is_changed) {
        is_changed = false;
        for (size_t i = count; i-- > 0;) {
            for (size_t r = 0; runs[i] && r < plan.steps[i].reads.size(); ++r) {
                if (producers_[i][r] < 0 || runs[static_cast<size_t>(producers_[i][r])])
                    continue;
                const auto producer = static_cast<size_t>(producers_[i][r]);
                const int slot = plan.steps[i].reads[r].index;
                bool is_lost = !holds_it(producer);
                for (size_t other = 0; other < i; ++other)
                    is_lost = is_lost || (runs[other] && plan.steps[other].writes(slot));
                if (is_lost)
                    runs[producer] = is_changed = true;
            }
        }
        // What runs under a condition wants it answered: of another image, a query decides nothing.
        for (const Plan::Step& step : plan.steps) {
            if (step.skipped_by < 0 || !runs[static_cast<size_t>(&step - plan.steps.data())])
                continue;
            const auto query = static_cast<size_t>(step.skipped_by);
            const auto counting = static_cast<size_t>(plan.queries[query].step);
            if (!runs[counting] && counted_[query] != wanted_[counting])
                runs[counting] = is_changed = true;
        }
        // An output that is held may be overwritten too, before the frame's end.
        for (const Plan::Output& output : plan.outputs) {
            const int producer = output.source == Plan::Read::Source::slot ? producer_of(plan, output.index, count) : -1;
            for (size_t other = 0; producer >= 0 && other < count; ++other)
                if (runs[other] && !runs[static_cast<size_t>(producer)] && plan.steps[other].writes(output.index))
                    runs[static_cast<size_t>(producer)] = is_changed = true;
        }
    }
    return runs;
}

std::vector<bool> Freshness::answers(const Plan& plan, const std::vector<bool>& runs, bool counts) const
{
    std::vector<bool> answers;
    for (size_t query = 0; query < plan.queries.size(); ++query) {
        const auto step = static_cast<size_t>(plan.queries[query].step);
        answers.push_back(runs[step] ? counts : counted_[query] == wanted_[step]);
    }
    return answers;
}

void Freshness::have_run(const Plan& plan, const std::vector<bool>& ran, bool counted)
{
    for (size_t query = 0; query < plan.queries.size(); ++query)
        if (const auto step = static_cast<size_t>(plan.queries[query].step); ran[step])
            counted_[query] = counted ? wanted_[step] : 0;
    for (size_t i = 0; i < plan.steps.size(); ++i)
        if (const std::vector<int> slots = plan.steps[i].written_slots(); ran[i])
            for (size_t k = 0; k < slots.size(); ++k)
                held_[static_cast<size_t>(slots[k])] = image_of(wanted_[i], k);
}

Freshness::CarriedOver Freshness::carry_over(const Plan& plan, const Versions& versions, Freshness& from)
{
    CarriedOver carried;
    find_wanted(plan, versions);
    for (size_t i = 0; i < plan.steps.size(); ++i) {
        const std::vector<int> slots = plan.steps[i].written_slots();
        for (size_t k = 0; k < slots.size(); ++k) {
            const std::uint64_t image = image_of(wanted_[i], k);
            const auto to = static_cast<size_t>(slots[k]);
            const auto found = std::find(from.held_.begin(), from.held_.end(), image);
            if (found == from.held_.end() || held_[to] == image)
                continue;
            carried.slots.push_back({static_cast<size_t>(found - from.held_.begin()), to});
            held_[to] = image;
            *found = 0;
        }
    }
    for (size_t query = 0; query < plan.queries.size(); ++query) {
        const std::uint64_t wanted = wanted_[static_cast<size_t>(plan.queries[query].step)];
        const auto found = std::find(from.counted_.begin(), from.counted_.end(), wanted);
        if (found == from.counted_.end() || counted_[query] == wanted)
            continue;
        carried.queries.push_back({static_cast<size_t>(found - from.counted_.begin()), query});
        counted_[query] = wanted;
        *found = 0;
    }
    return carried;
}

void Freshness::forget()
{
    std::fill(held_.begin(), held_.end(), 0);
    std::fill(counted_.begin(), counted_.end(), 0);
}

} // namespace passgraph::gl
