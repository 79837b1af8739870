// What changes under the window: files, and the plans that are made of them.
#include <algorithm>
#include <cstdio>

#include <fmt/format.h>

#include "tool/view/scene_files.hpp"
#include "tool/view/session.hpp"

namespace passgraph::tool::view {
namespace {

constexpr double kResizeSettles = 0.08;  // seconds: a plan is made for an extent that stays this long
constexpr double kThumbnailsAfter = 0.2; // seconds of rest

bool is_of_passes(const std::string& file)
{
    return file.ends_with(".glsl") || file.ends_with(".graph.json");
}

std::string file_name(const std::string& path)
{
    return std::filesystem::path(path).filename().string();
}

bool same_camera(const Camera& a, const Camera& b)
{
    return a.position == b.position && a.direction == b.direction && a.up == b.up && a.vertical_fov == b.vertical_fov &&
           a.near_plane == b.near_plane && a.far_plane == b.far_plane;
}

} // namespace

WatchedPaths watched_paths(const ViewOptions& options)
{
    WatchedPaths paths{options.graphs, options.pass_folders};
    if (!options.scene.empty())
        for (std::string& file : files_of_scene(options.scene))
            paths.files.push_back(std::move(file));
    return paths;
}

void Session::watch_files()
{
    const std::vector<std::string> changed = watch_.look();
    if (changed.empty())
        return;
    const auto is_graph = [&](const std::string& file) {
        return std::find(options_.graphs.begin(), options_.graphs.end(), file) != options_.graphs.end() || is_of_passes(file);
    };
    if (std::any_of(changed.begin(), changed.end(), is_graph))
        loader_->request_passes();
    if (!options_.scene.empty() && !std::all_of(changed.begin(), changed.end(), is_graph))
        loader_->request_scene();
    change_ = Change{changed.size() == 1 ? file_name(changed.front()) : fmt::format("{} files", changed.size()),
                     FileWatch::latest(changed)};
}

/// Mistakes go to the terminal once: those that were not there before.
void Session::tell(const Errors& before, const Errors& after) const
{
    const auto same = [](const Error& a, const Error& b) { return a.code == b.code && a.message == b.message && a.where == b.where; };
    for (const Error& error : after)
        if (std::none_of(before.begin(), before.end(), [&](const Error& old) { return same(old, error); }))
            fmt::print(stderr, "{}\n", to_text(error));
}

void Session::take_loaded()
{
    if (std::optional<LoadedPasses> loaded = loader_->take_passes()) {
        const Errors before = std::exchange(state_.mistakes.passes, std::move(loaded->errors));
        tell(before, state_.mistakes.passes);
        state_.library = std::move(loaded->library);
        for (size_t i = 0; i < state_.stacks.size(); ++i)
            if (loaded->graphs[i])
                state_.stacks[i].description = std::move(loaded->graphs[i]);
        refresh_controls();
        needs_plan_ = true;
        presents_ = 3;
    }
    if (std::optional<LoadedScene> loaded = loader_->take_scene())
        take_scene(std::move(*loaded));
    take_scene_images();
    show_coming_scene();
}

void Session::keep_scene_errors(Errors errors)
{
    const Errors before = std::exchange(state_.mistakes.scene, std::move(errors));
    tell(before, state_.mistakes.scene);
    presents_ = 3;
}

/// The slow part of taking in a scene goes on beside the window.
void Session::take_scene(LoadedScene loaded)
{
    if (!loaded.scene) {
        keep_scene_errors(std::move(loaded.errors));
        return;
    }
    if (scene_images_.valid())
        scene_images_.wait(); // those of a scene that is out of date already
    coming_scene_ = std::move(loaded.scene);
    coming_images_.reset();
    scene_images_ = std::async(std::launch::async, [renderer = &stage_.renderer(), scene = coming_scene_] {
        Result<SceneImages> images = renderer->images_of(*scene);
        Window::wake();
        return images;
    });
}

void Session::take_scene_images()
{
    if (!scene_images_.valid() || scene_images_.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
        return;
    Result<SceneImages> images = scene_images_.get();
    if (images) {
        coming_images_ = std::move(*images);
        return;
    }
    coming_scene_.reset();
    keep_scene_errors(images.error());
}

/// A plan for what the old scene calls for would draw the new one wrongly: one for both runs in between.
void Session::show_coming_scene()
{
    if (!coming_images_)
        return;
    const Facts facts = coming_images_->facts();
    const bool is_right = !scene_ || !stage_.is_ready() || broken_promises(stage_.plan().facts, facts).empty();
    if (!is_right && state_.mistakes.plan.empty()) {
        const Facts both = either(stage_.plan().facts, facts);
        needs_plan_ |= !(facts_ == both);
        facts_ = both;
        return;
    }
    needs_plan_ |= !(facts_ == facts);
    facts_ = facts;
    const std::shared_ptr<const Scene> scene = std::exchange(coming_scene_, nullptr);
    const Result<void> set = stage_.set_scene(scene, std::move(*std::exchange(coming_images_, std::nullopt)));
    keep_scene_errors(set ? Errors{} : set.error());
    if (!set)
        return;
    // A flight goes on, unless the file has another camera now.
    const bool is_same_camera = scene_ && same_camera(scene_->camera, scene->camera);
    scene_ = scene;
    if (!is_same_camera)
        reset_camera();
    needs_frame_ = true;
    inspector_.plan_changed();
    watch_.watch(watched_paths(options_)); // it may name other models now
}

void Session::refresh_controls()
{
    if (!state_.stack().description)
        return;
    state_.controls = controls_of(*state_.stack().description, *state_.library, state_.stack().settings);
    state_.images = images_of(state_.stack(), *state_.library);
    Stack& stack = state_.stack();
    if (std::find(state_.images.begin(), state_.images.end(), stack.shown) == state_.images.end())
        stack.shown.clear(); // the graph has lost it
}

void Session::plan_again()
{
    needs_plan_ = false;
    planned_extent_ = wanted_extent();
    inspector_.plan_changed();
    const Errors before = std::exchange(state_.mistakes.plan, {});
    Result<Plan> plan = plan_of(state_.stack(), *state_.library, compile_options());
    if (plan) {
        stage_.want(std::move(*plan));
        needs_frame_ |= !stage_.is_waiting(); // live values alone have changed; else the coming plan draws
    } else {
        state_.mistakes.plan = plan.error();
    }
    tell(before, state_.mistakes.plan);
}

void Session::work_on_plans()
{
    const Extent extent{window_->width(), window_->height()};
    if (!(extent == window_extent_)) {
        window_extent_ = extent;
        resized_at_ = now();
        presents_ = 3;
    }
    const bool is_first = planned_extent_ == Extent{};
    const bool is_settled = is_first || now() - resized_at_ >= kResizeSettles;
    if (needs_plan_ || (!(wanted_extent() == planned_extent_) && is_settled))
        plan_again();
    if (is_awaiting_scene())
        return; // programs would be drawn with nothing, and compiled again
    if (stage_.is_waiting()) {
        const bool was_ready = stage_.is_ready();
        const Errors errors = stage_.work();
        if (!errors.empty()) {
            tell(state_.mistakes.plan, errors);
            state_.mistakes.plan = errors;
        }
        needs_frame_ |= !stage_.is_waiting() && errors.empty();
        presents_ = std::max(presents_, was_ready ? 1 : 2);
        return;
    }
    const Camera camera = flight_ ? flight_->camera() : Camera{};
    const CompileOptions options = compile_options();
    if (inspector_.is_asked()) {
        if (inspector_.work_on_answer(inspected(flight_ ? &camera : nullptr, options)))
            print_answer();
        presents_ = 3;
    } else if (state_.shows_panel && state_.shows_thumbnails && inspector_.has_old_thumbnails() &&
               now() - last_change_ > kThumbnailsAfter) {
        inspector_.work_on_thumbnails(inspected(flight_ ? &camera : nullptr, options));
        presents_ = 3;
    }
}

/// The values as data, too: a line per image, with the texel and its numbers.
void Session::print_answer() const
{
    for (const ProbedValue& probed : inspector_.answer())
        fmt::print("{} {},{} {}\n", probed.image, probed.x, probed.y, fmt::join(probed.values, " "));
    std::fflush(stdout);
}

void Session::tell_how_long()
{
    const auto age = std::filesystem::file_time_type::clock::now() - change_->saved;
    const double ms = std::chrono::duration<double, std::milli>(age).count();
    if (state_.mistakes.all().empty())
        say(fmt::format("{}: seen {:.0f} ms after it was saved", change_->what, ms));
    change_.reset();
}

} // namespace passgraph::tool::view
