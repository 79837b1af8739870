// Loads a graph's sources and brings them to a renderer.
#include "tool/job.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <passgraph/image/image_file.hpp>
#include <passgraph/scene/facts.hpp>
#include <passgraph/scene/scene_file.hpp>

#include "tool/pictures.hpp"
#include "tool/progress.hpp"

namespace passgraph::tool {
namespace {

bool is_import(const GraphNode& node) { return node.kind == GraphNode::Kind::picture || node.kind == GraphNode::Kind::cube; }

/// "`image` (radiance), `sky` (radiance, a folder)", for hints.
std::string wanted_inputs(const Graph& graph)
{
    std::string text;
    for (const GraphNode& node : graph.nodes())
        if (is_import(node))
            text += fmt::format("{}`{}` ({}{})", text.empty() ? "" : ", ", node.name, info(node.signal).name,
                                node.kind == GraphNode::Kind::cube ? ", a folder with px nx py ny pz nz" : "");
    return text.empty() ? "the graph takes no pictures" : "the graph takes " + text;
}

void load_input(const GraphNode& node, const Pair& pair, Sources& sources, Errors& errors)
{
    const Progress progress(fmt::format("reading {}", pair.text));
    if (node.kind == GraphNode::Kind::cube) {
        const bool decodes = node.signal == Signal::radiance || node.signal == Signal::albedo;
        auto faces = read_cube(pair.text, decodes ? Transfer::decode_srgb : Transfer::as_is);
        if (faces)
            sources.cubes.emplace(node.name, std::move(*faces));
        else
            append(errors, faces.error());
        return;
    }
    Result<Picture> picture = read_values(pair.text, node.signal);
    if (picture)
        sources.pictures.emplace(node.name, std::move(*picture));
    else
        append(errors, picture.error());
}

int scaled(int side, int to, int from)
{
    const double product = std::round(static_cast<double>(side) * to / from);
    return static_cast<int>(std::clamp(product, 1.0, 1e9));
}

/// The frame's extent and the pictures': the option's, the first picture's, or the default.
void choose_extents(Sources& sources, const std::string& first, std::optional<Extent> size)
{
    const auto found = sources.pictures.find(first);
    const Extent natural = found == sources.pictures.end() ? sources.extent : found->second.extent;
    sources.extent = size.value_or(natural);
    for (const auto& [name, picture] : sources.pictures) {
        Extent extent = picture.extent;
        if (name == first) // exactly, even a side of 0, which the compiler refuses
            extent = sources.extent;
        else if (size && found != sources.pictures.end())
            extent = {scaled(extent.width, size->width, natural.width), scaled(extent.height, size->height, natural.height)};
        sources.picture_extents[name] = extent;
    }
}

Sources load_sources(const Graph& graph, const SourceOptions& options, Errors& errors)
{
    Sources sources;
    std::string first;
    std::vector<std::string> given;
    for (const Pair& pair : pairs_of("--in", options.pictures)) {
        const int node = graph.find_node(pair.name);
        if (node < 0 || !is_import(graph.nodes()[static_cast<size_t>(node)])) {
            errors.push_back({"unknown_input", fmt::format("the graph has no picture input `{}`", pair.name), wanted_inputs(graph), pair.where});
        } else if (std::find(given.begin(), given.end(), pair.name) != given.end()) {
            errors.push_back({"duplicate_name", fmt::format("the input `{}` is given twice", pair.name), "give one file", pair.where});
        } else {
            given.push_back(pair.name);
            load_input(graph.nodes()[static_cast<size_t>(node)], pair, sources, errors);
            if (first.empty() && sources.pictures.contains(pair.name))
                first = pair.name;
        }
    }
    choose_extents(sources, first, options.extent());
    if (!options.scene.empty()) {
        const Progress progress(fmt::format("loading {}", options.scene));
        Result<Scene> scene = load_scene(options.scene);
        if (scene)
            sources.scene = std::move(*scene);
        else
            append(errors, scene.error());
    }
    return sources;
}

bool needs_scene(const Plan& plan)
{
    return std::any_of(plan.imports.begin(), plan.imports.end(), [](const auto& import) { return import.is_of_scene(); }) || std::any_of(plan.steps.begin(), plan.steps.end(), [](const Plan::Step& step) {
               return step.kind == Plan::Step::Kind::geometry || step.host.camera || step.host.lights || step.host.elements;
           });
}

void find_missing(const Job& job, const SourceOptions& options, Errors& errors)
{
    const auto is_given = [&](const std::string& name) {
        const std::vector<Pair> pairs = pairs_of("--in", options.pictures);
        return std::any_of(pairs.begin(), pairs.end(), [&](const Pair& pair) { return pair.name == name; });
    };
    for (const Plan::Import& import : job.plan.imports)
        if (!import.is_of_scene() && !is_given(import.name))
            errors.push_back({.code = "input_missing",
                              .message = fmt::format("the input `{}` ({}) is not given", import.name, info(import.signal).name),
                              .hint = fmt::format("add --in {}={}; {}", import.name,
                                                  import.kind == Plan::Import::Kind::cube ? "FOLDER" : "FILE", wanted_inputs(job.graph))});
    if (needs_scene(job.plan) && options.scene.empty())
        errors.push_back({.code = "scene_missing", .message = "the graph draws a scene, and none is given", .hint = "add --scene FILE"});
}

} // namespace

Result<Job> prepare_for(const Device& device, Graph graph, const SourceOptions& options, const CompilerOptions& compiler, bool draws)
{
    Errors errors;
    Job job{std::move(graph), {}, {}, {}};
    job.sources = load_sources(job.graph, options, errors);
    job.options.extent = job.sources.extent;
    job.options.device = device;
    if (job.sources.scene)
        job.options.facts = facts_of(*job.sources.scene);
    job.options.picture_extents = job.sources.picture_extents;
    compiler.apply_to(job.options);
    Result<Plan> plan = compile(job.graph, job.options);
    if (plan) {
        job.plan = std::move(*plan);
        if (draws)
            find_missing(job, options, errors);
    } else {
        append(errors, plan.error());
    }
    if (!errors.empty())
        return tl::unexpected(std::move(errors));
    return job;
}

Result<Job> prepare(Graph graph, const SourceOptions& sources, const CompilerOptions& compiler)
{
    return prepare_for(CompileOptions{}.device, std::move(graph), sources, compiler, true);
}

Result<Renderer> create_renderer(const Job& job, const CompileOptions& options, const RendererOptions& device)
{
    const Progress progress("preparing the device");
    const Result<Device> limits = query_device(device.loader);
    if (!limits)
        return tl::unexpected(limits.error());
    CompileOptions fitting = options;
    fitting.device = *limits;
    Result<Plan> plan = compile(job.graph, fitting);
    if (!plan)
        return tl::unexpected(plan.error());
    Result<Renderer> renderer = Renderer::create(std::move(*plan), device);
    if (!renderer)
        return renderer;
    Errors errors;
    const auto keep = [&](const Result<void>& done) {
        if (!done)
            append(errors, done.error());
    };
    if (job.sources.scene)
        keep(renderer->set_scene(*job.sources.scene));
    // Inputs that the plan does not read are not uploaded.
    for (const Plan::Import& import : renderer->plan().imports) {
        if (const auto picture = job.sources.pictures.find(import.name); picture != job.sources.pictures.end())
            keep(renderer->import_picture(import.name, resized(picture->second, import.extent)));
        if (const auto cube = job.sources.cubes.find(import.name); cube != job.sources.cubes.end())
            keep(renderer->import_cube(import.name, cube->second));
    }
    if (!errors.empty())
        return tl::unexpected(std::move(errors));
    return renderer;
}

} // namespace passgraph::tool
