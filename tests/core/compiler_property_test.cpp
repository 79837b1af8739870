// What must hold of every plan, over random graphs.
#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "core_support.hpp"
#include "random_graph.hpp"
#include "support/catch.hpp"

using namespace passgraph;
using namespace passgraph::test;

namespace {

constexpr unsigned kGraphs = 300;

template <class Check>
void for_random_graphs(const Check& check)
{
    for (unsigned seed = 0; seed < kGraphs; ++seed) {
        INFO("seed " << seed);
        const RandomGraph made = random_graph(seed);
        check(made);
    }
}

/// The passes that an output depends on, found by following wires from the outputs.
std::set<std::string> needed_passes(const Graph& graph)
{
    std::set<std::string> needed;
    std::vector<int> open;
    for (const GraphOutput& output : graph.outputs())
        open.push_back(output.from.node);
    while (!open.empty()) {
        const GraphNode& node = graph.nodes()[static_cast<size_t>(open.back())];
        open.pop_back();
        if (node.kind != GraphNode::Kind::pass || !needed.insert(node.name).second)
            continue;
        for (const auto& wire : node.inputs)
            open.push_back(wire->from.node);
    }
    return needed;
}

std::map<std::string, int> step_of_pass(const Plan& plan)
{
    std::map<std::string, int> steps;
    for (size_t i = 0; i < plan.steps.size(); ++i)
        for (const std::string& pass : plan.steps[i].passes)
            CHECK(steps.emplace(pass, static_cast<int>(i)).second); // each pass runs once
    return steps;
}

/// Runs the plan on names instead of pixels: each slot holds the image that was last written to it.
void execute(const Plan& plan)
{
    std::map<int, std::string> held;
    for (const Plan::Step& step : plan.steps) {
        INFO(step.name);
        CHECK(!step.targets.empty());
        CHECK(step.extent.width > 0);
        std::set<int> read;
        for (const Plan::Read& source : step.reads) {
            if (source.source == Plan::Read::Source::import)
                continue;
            CHECK(held[source.index] == source.image); // written before, and not overwritten since
            read.insert(source.index);
        }
        std::set<int> written;
        for (const Plan::Target& target : step.targets) {
            const Plan::Slot& slot = plan.slots[static_cast<size_t>(target.slot)];
            CHECK(!read.contains(target.slot)); // no feedback loop
            CHECK(written.insert(target.slot).second);
            CHECK(slot.extent == step.extent);
            held[target.slot] = target.image;
        }
    }
    for (const Plan::Output& output : plan.outputs)
        if (output.source == Plan::Read::Source::slot)
            CHECK(held[output.index] == output.image);
}

using Descriptor = std::tuple<Format, int, int>;

struct Life {
    Descriptor descriptor;
    int slot = 0;
    int first = 0;
    int last = 0;
};

/// When each stored image is alive, read off the plan's steps alone.
std::map<std::string, Life> lives_of(const Plan& plan)
{
    std::map<std::string, Life> lives;
    for (size_t time = 0; time < plan.steps.size(); ++time) {
        for (const Plan::Target& target : plan.steps[time].targets) {
            const Plan::Slot& slot = plan.slots[static_cast<size_t>(target.slot)];
            lives[target.image] = {{slot.format, slot.extent.width, slot.extent.height}, target.slot, static_cast<int>(time), static_cast<int>(time)};
        }
        for (const Plan::Read& read : plan.steps[time].reads)
            if (read.source == Plan::Read::Source::slot)
                lives[read.image].last = static_cast<int>(time);
    }
    for (const Plan::Output& output : plan.outputs)
        if (output.source == Plan::Read::Source::slot)
            lives[output.image].last = static_cast<int>(plan.steps.size());
    return lives;
}

/// Each wire is served: by a texture the step reads, or inside the step by a pointwise read of an equal extent.
void check_wires(const Graph& graph, const Plan& plan)
{
    const auto steps = step_of_pass(plan);
    for (const GraphNode& node : graph.nodes()) {
        if (!steps.contains(node.name))
            continue;
        const Plan::Step& step = plan.steps[static_cast<size_t>(steps.at(node.name))];
        const auto place = std::find(step.passes.begin(), step.passes.end(), node.name);
        for (size_t port = 0; port < node.inputs.size(); ++port) {
            const ImageRef from = node.inputs[port]->from;
            const std::string& producer = graph.nodes()[static_cast<size_t>(from.node)].name;
            INFO(node.name << " reads " << graph.image_name(from));
            if (std::find(step.passes.begin(), place, producer) != place) {
                const AccessClass kind = node.pass->inputs[port].access.kind;
                CHECK((kind == AccessClass::pointwise || kind == AccessClass::size_only));
                continue;
            }
            CHECK(std::find(step.passes.begin(), step.passes.end(), producer) == step.passes.end()); // never a later pass of the step
            const InputPort& input = node.pass->inputs[port];
            CHECK(std::any_of(step.reads.begin(), step.reads.end(), [&](const Plan::Read& read) {
                const auto index = static_cast<size_t>(read.index);
                const Extent extent = read.source == Plan::Read::Source::slot ? plan.slots[index].extent : plan.imports[index].extent;
                // A linear filter at a texel's own center is the texel.
                const bool is_own_texel = input.access.kind == AccessClass::pointwise && extent == step.extent;
                return read.image == graph.image_name(from) && (read.filter == input.filter || is_own_texel);
            }));
            if (steps.contains(producer))
                CHECK(steps.at(producer) < steps.at(node.name));
        }
    }
}

size_t live_pass_count(const Plan& plan)
{
    size_t count = 0;
    for (const Plan::Step& step : plan.steps)
        count += step.passes.size();
    return count;
}

} // namespace

TEST_CASE("every image a step reads was written before and not overwritten since", "[core][compiler]")
{
    for_random_graphs([](const RandomGraph& made) {
        for (const bool fuse : {true, false}) {
            for (const bool cull : {true, false}) {
                CompileOptions options = made.options;
                options.fuse = fuse;
                options.cull = cull;
                const Plan plan = planned(made.graph, options);
                execute(plan);
                check_wires(made.graph, plan);
            }
        }
    });
}

TEST_CASE("random graphs exercise what is tested: fusion, sharing, culling, every reason", "[core][compiler]")
{
    size_t fused = 0;
    size_t shared = 0;
    size_t culled = 0;
    std::map<std::string, int> reasons;
    for_random_graphs([&](const RandomGraph& made) {
        const Plan plan = planned(made.graph, made.options);
        fused += live_pass_count(plan) - plan.steps.size();
        culled += plan.culled.size();
        for (const Plan::Slot& slot : plan.slots)
            shared += slot.images.size() - 1;
        for (const Plan::Boundary& boundary : plan.boundaries)
            for (const char* reason : {"reads it as warp", "reads it as gather(2)", "reads it as gather(radius unknown)", "extents differ", "stands between",
                                       "textures, the device allows", "images, the device allows"})
                if (boundary.reason.find(reason) != std::string::npos)
                    ++reasons[reason];
    });
    CHECK(fused > 300);
    CHECK(shared > 100);
    CHECK(culled > 100);
    CHECK(reasons.size() == 7);
}

TEST_CASE("images that share a slot are never alive together, and no fewer slots could do", "[core][compiler]")
{
    for_random_graphs([](const RandomGraph& made) {
        for (const bool fuse : {true, false}) {
            CompileOptions options = made.options;
            options.fuse = fuse;
            const Plan plan = planned(made.graph, options);
            const auto lives = lives_of(plan);
            for (const auto& [image, life] : lives)
                for (const auto& [other, its] : lives)
                    if (image < other && life.slot == its.slot)
                        CHECK((life.last < its.first || its.last < life.first));
            std::map<Descriptor, int> slots;
            for (const Plan::Slot& slot : plan.slots)
                ++slots[{slot.format, slot.extent.width, slot.extent.height}];
            std::map<Descriptor, int> most_alive;
            for (int time = 0; time <= static_cast<int>(plan.steps.size()); ++time) {
                std::map<Descriptor, int> alive;
                for (const auto& [image, life] : lives)
                    if (life.first <= time && time <= life.last)
                        most_alive[life.descriptor] = std::max(most_alive[life.descriptor], ++alive[life.descriptor]);
            }
            CHECK(slots == most_alive);
        }
    });
}

TEST_CASE("the passes that run are exactly those an output needs", "[core][compiler]")
{
    for_random_graphs([](const RandomGraph& made) {
        const Plan plan = planned(made.graph, made.options);
        const std::set<std::string> needed = needed_passes(made.graph);
        std::set<std::string> run;
        for (const auto& [pass, step] : step_of_pass(plan))
            run.insert(pass);
        CHECK(run == needed);
        for (const Plan::Culled& culled : plan.culled) {
            CHECK(!needed.contains(culled.pass));
            CHECK(!culled.reason.empty());
        }
        size_t passes = 0;
        for (const GraphNode& node : made.graph.nodes())
            passes += node.kind == GraphNode::Kind::pass ? 1 : 0;
        CHECK(plan.culled.size() + run.size() == passes);
        CompileOptions all = made.options;
        all.cull = false;
        CHECK(live_pass_count(planned(made.graph, all)) == passes);
    });
}

TEST_CASE("without fusion every pass is a step, without sharing every image a slot", "[core][compiler]")
{
    for_random_graphs([](const RandomGraph& made) {
        CompileOptions options = made.options;
        options.fuse = false;
        options.alias = false;
        const Plan plan = planned(made.graph, options);
        for (const Plan::Step& step : plan.steps)
            CHECK(step.passes.size() == 1);
        CHECK(plan.inlined.empty());
        CHECK(plan.bytes == plan.bytes_unshared);
        size_t targets = 0;
        for (const Plan::Step& step : plan.steps)
            targets += step.targets.size();
        CHECK(plan.slots.size() == targets);
        execute(plan);
        const Plan shared = planned(made.graph, made.options);
        CHECK(shared.bytes <= shared.bytes_unshared);
        std::int64_t bytes = 0;
        for (const Plan::Slot& slot : shared.slots)
            bytes += static_cast<std::int64_t>(bytes_per_texel(slot.format)) * slot.extent.width * slot.extent.height;
        CHECK(shared.bytes == bytes);
    });
}

TEST_CASE("plans are equal byte for byte when compiled again", "[core][compiler]")
{
    for_random_graphs([](const RandomGraph& made) {
        const RandomGraph again = random_graph(0); // other memory in between
        const Plan first = planned(made.graph, made.options);
        const Plan second = planned(made.graph, made.options);
        CHECK(to_text(first) == to_text(second));
        CHECK(to_json(first, true) == to_json(second, true));
        CHECK(to_dot(first) == to_dot(second));
    });
    CHECK(to_json(planned(random_graph(7).graph, random_graph(7).options), true) == to_json(planned(random_graph(7).graph, random_graph(7).options), true));
}

TEST_CASE("every edge that stays a texture has a reason, and fusion stops only there", "[core][compiler]")
{
    for_random_graphs([](const RandomGraph& made) {
        const Plan plan = planned(made.graph, made.options);
        const auto steps = step_of_pass(plan);
        std::set<std::pair<std::string, std::string>> kept;
        for (const Plan::Boundary& boundary : plan.boundaries) {
            INFO(boundary.image << " -> " << boundary.reader);
            CHECK(!boundary.reason.empty());
            CHECK(steps.contains(boundary.reader));
            CHECK(kept.emplace(boundary.image, boundary.reader).second);
        }
        for (const GraphNode& node : made.graph.nodes()) {
            if (!steps.contains(node.name))
                continue;
            for (const auto& wire : node.inputs) {
                const std::string& producer = made.graph.nodes()[static_cast<size_t>(wire->from.node)].name;
                if (steps.contains(producer))
                    CHECK(kept.contains({made.graph.image_name(wire->from), node.name}) == (steps.at(producer) != steps.at(node.name)));
            }
        }
        // An image stays in registers exactly when no step reads it and it is no output.
        const auto lives = lives_of(plan);
        for (const std::string& image : plan.inlined)
            CHECK(!lives.contains(image));
    });
}
