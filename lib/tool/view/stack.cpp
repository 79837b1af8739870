// Plans of a stack.
#include "tool/view/stack.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace passgraph::tool::view {
namespace {

Graph graph_of(const Stack& stack, const PassLibrary& library, const std::vector<std::string>& images)
{
    GraphDescription description = *stack.description;
    if (!images.empty())
        description.outputs.clear();
    for (const std::string& image : images)
        description.outputs.push_back({image, {image, {}}, {}});
    Graph graph = build_graph(description, library);
    apply_settings(stack.settings, graph);
    return graph;
}

bool same_steps(const Plan::Step& a, const Plan::Step& b)
{
    const auto same_read = [](const Plan::Read& x, const Plan::Read& y) {
        return x.source == y.source && x.index == y.index && x.sampler == y.sampler && x.filter == y.filter && x.wrap == y.wrap &&
               x.has_levels == y.has_levels && x.is_loaded == y.is_loaded;
    };
    const auto same_target = [](const Plan::Target& x, const Plan::Target& y) { return x.slot == y.slot; };
    const auto same_uniform = [](const Plan::Uniform& x, const Plan::Uniform& y) {
        return x.name == y.name && x.place == y.place && x.type == y.type && x.lowest == y.lowest && x.highest == y.highest;
    };
    return a.kind == b.kind && a.extent == b.extent && a.depth_slot == b.depth_slot &&
           a.tested_depth_slot == b.tested_depth_slot && a.vertex == b.vertex && a.fragment == b.fragment &&
           a.background == b.background && a.counts == b.counts && a.skipped_by == b.skipped_by &&
           a.when_skipped == b.when_skipped && a.scout == b.scout && a.scout_extent == b.scout_extent &&
           std::equal(a.reads.begin(), a.reads.end(), b.reads.begin(), b.reads.end(), same_read) &&
           std::equal(a.targets.begin(), a.targets.end(), b.targets.begin(), b.targets.end(), same_target) &&
           std::equal(a.uniforms.begin(), a.uniforms.end(), b.uniforms.begin(), b.uniforms.end(), same_uniform);
}

/// The file's settings that one name stands for, through the graph's own params, which may name each other.
void follow(const std::string& name, const GraphDescription& description, int depth, std::vector<std::string>& places)
{
    bool is_param = false;
    for (const GraphParam& param : description.params) {
        if (param.name != name || depth > 8)
            continue;
        is_param = true;
        for (const std::string& place : param.places)
            follow(place, description, depth + 1, places);
    }
    if (!is_param)
        places.push_back(name);
}

} // namespace

std::string stack_name(const std::string& file)
{
    const size_t slash = file.rfind('/');
    const std::string name = slash == std::string::npos ? file : file.substr(slash + 1);
    return name.substr(0, name.find('.'));
}

std::vector<std::string> images_of(const Stack& stack, const PassLibrary& library)
{
    std::vector<std::string> images;
    const Graph graph = graph_of(stack, library, {});
    for (size_t node = 0; node < graph.nodes().size(); ++node) {
        if (graph.nodes()[node].kind != GraphNode::Kind::pass)
            continue;
        for (size_t output = 0; output < graph.nodes()[node].pass->outputs.size(); ++output)
            images.push_back(graph.image_name({static_cast<int>(node), static_cast<int>(output)}));
    }
    return images;
}

Result<Plan> plan_of(const Stack& stack, const PassLibrary& library, const CompileOptions& options)
{
    std::vector<std::string> images;
    if (!stack.shown.empty())
        images.push_back(stack.shown);
    return compile(graph_of(stack, library, images), options);
}

Result<Plan> plan_of_all_images(const Stack& stack, const PassLibrary& library, const CompileOptions& options)
{
    return compile(graph_of(stack, library, images_of(stack, library)), options);
}

bool runs_alike(const Plan& a, const Plan& b)
{
    const auto same_slot = [](const Plan::Slot& x, const Plan::Slot& y) { return x.format == y.format && x.extent == y.extent; };
    const auto same_import = [](const Plan::Import& x, const Plan::Import& y) {
        return x.kind == y.kind && x.name == y.name && x.signal == y.signal && x.extent == y.extent;
    };
    const auto same_output = [&](const Plan::Output& x, const Plan::Output& y) {
        return x.name == y.name && x.source == y.source && x.signal == y.signal && x.codec == y.codec && x.index == y.index;
    };
    return a.extent == b.extent && a.facts == b.facts && std::equal(a.slots.begin(), a.slots.end(), b.slots.begin(), b.slots.end(), same_slot) &&
           std::equal(a.imports.begin(), a.imports.end(), b.imports.begin(), b.imports.end(), same_import) &&
           std::equal(a.outputs.begin(), a.outputs.end(), b.outputs.begin(), b.outputs.end(), same_output) &&
           std::equal(a.steps.begin(), a.steps.end(), b.steps.begin(), b.steps.end(), same_steps);
}

Settings settings_by_place(const std::vector<PassArguments::Setting>& settings, const GraphDescription& description)
{
    Settings by_place;
    for (const PassArguments::Setting& setting : settings) {
        std::vector<std::string> places;
        follow(setting.name, description, 0, places);
        for (const std::string& place : places) {
            by_place[place] = setting;
            by_place[place].name = place;
        }
    }
    return by_place;
}

} // namespace passgraph::tool::view
