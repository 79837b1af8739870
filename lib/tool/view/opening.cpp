// What happens before there is a window: everything is read, and mistakes end the program.
#include <algorithm>
#include <thread>

#include <fmt/format.h>

#include "tool/preset.hpp"
#include "tool/view/session.hpp"

namespace passgraph::tool::view {
namespace {

/// Waits for the loader's first answers.
void wait_for(Loader& loader, LoadedPasses& passes, LoadedScene& scene)
{
    bool has_passes = false;
    bool has_scene = false;
    while (!has_passes || !has_scene) {
        if (auto loaded = loader.take_passes()) {
            passes = std::move(*loaded);
            has_passes = true;
        }
        if (auto loaded = loader.take_scene()) {
            scene = std::move(*loaded);
            has_scene = true;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
}

bool needs_scene(const Plan& plan)
{
    return std::any_of(plan.imports.begin(), plan.imports.end(), [](const auto& import) { return import.is_of_scene(); }) ||
           std::any_of(plan.steps.begin(), plan.steps.end(), [](const Plan::Step& step) {
               return step.kind == Plan::Step::Kind::geometry || step.host.camera || step.host.lights || step.host.elements;
           });
}

/// A setting of the preset has to fit one graph at least.
void apply_preset(const std::string& file, std::vector<Stack>& stacks, const PassLibrary& library, Errors& errors)
{
    const auto preset = read_preset(file);
    if (!preset) {
        append(errors, preset.error());
        return;
    }
    for (const PassArguments::Setting& setting : *preset) {
        Errors refusals;
        size_t refused = 0;
        for (Stack& stack : stacks) {
            Graph graph = build_graph(*stack.description, library);
            if (const Result<void> set = graph.set(setting.name, setting); !set) {
                if (refused++ == 0)
                    refusals = set.error();
                continue;
            }
            for (auto& [place, value] : settings_by_place({setting}, *stack.description))
                stack.settings[place] = value;
        }
        if (refused == stacks.size())
            append(errors, refusals);
    }
}

/// The errors of a plan's inputs: the window has a scene for them, and nothing else.
void check_inputs(const Plan& plan, const Stack& stack, bool has_scene, Errors& errors)
{
    for (const Plan::Import& import : plan.imports)
        if (!import.is_of_scene())
            errors.push_back({.code = "input_missing",
                              .message = fmt::format("the input `{}` ({}) cannot be given to the window", import.name,
                                                     info(import.signal).name),
                              .hint = "view shows graphs of a scene; use render for graphs of pictures",
                              .where = {stack.file}});
    if (needs_scene(plan) && !has_scene)
        errors.push_back({.code = "scene_missing",
                          .message = "the graph draws a scene, and none is given",
                          .hint = "add --scene FILE",
                          .where = {stack.file}});
}

} // namespace

Result<Opening> open_files(const ViewOptions& options)
{
    Opening opening;
    opening.loader = std::make_unique<Loader>(LoaderFiles{options.pass_folders, options.graphs, options.scene}, &Window::wake);
    opening.loader->request_passes();
    opening.loader->request_scene();
    LoadedPasses passes;
    LoadedScene scene;
    wait_for(*opening.loader, passes, scene);
    Errors errors = scene.errors;
    for (size_t i = 0; i < options.graphs.size(); ++i) {
        opening.stacks.push_back({.file = options.graphs[i], .name = stack_name(options.graphs[i]), .description = passes.graphs[i]});
        if (!passes.graphs[i])
            append(errors, passes.errors);
    }
    if (errors.empty() && !options.preset.empty())
        apply_preset(options.preset, opening.stacks, *passes.library, errors);
    for (const Stack& stack : opening.stacks) {
        if (!errors.empty())
            break;
        const Result<Plan> plan = plan_of(stack, *passes.library, {});
        if (!plan)
            append(errors, plan.error());
        else
            check_inputs(*plan, stack, scene.scene != nullptr, errors);
    }
    if (!errors.empty())
        return tl::unexpected(std::move(errors));
    opening.library = std::move(passes.library);
    opening.scene = std::move(scene.scene);
    opening.pass_errors = std::move(passes.errors);
    return opening;
}

} // namespace passgraph::tool::view
