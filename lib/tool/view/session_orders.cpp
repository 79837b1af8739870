// What keys and panel ask the session for.
#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include <passgraph/image/image_file.hpp>

#include "tool/csv.hpp"
#include "tool/preset.hpp"
#include "tool/view/graph_edit.hpp"
#include "tool/view/session.hpp"

namespace passgraph::tool::view {
namespace {

constexpr double kNoticeSeconds = 4.0;

/// "FOLDER/NAME_0001.png": the first number that is free.
std::string free_file(const std::string& folder, const std::string& name)
{
    for (int number = 1;; ++number) {
        const std::string file = (std::filesystem::path(folder) / fmt::format("{}_{:04}.png", name, number)).string();
        std::error_code failed;
        if (!std::filesystem::exists(file, failed))
            return file;
    }
}

std::string without_dots(std::string name)
{
    std::replace(name.begin(), name.end(), '.', '_');
    return name;
}

} // namespace

void Session::say(std::string notice)
{
    fmt::print(stderr, "{}\n", notice);
    state_.notice = std::move(notice);
    state_.notice_until = now() + kNoticeSeconds;
    presents_ = std::max(presents_, 2);
}

void Session::obey(const Order& order)
{
    switch (order.command) {
    case Command::pick_stack: pick_stack(static_cast<size_t>(order.index)); break;
    case Command::reload_passes:
        say("reading passes and graphs again");
        loader_->request_passes();
        break;
    case Command::reload_scene:
        say("reading the scene again");
        loader_->request_scene();
        break;
    case Command::full_screen: window_->set_full_screen(!window_->is_full_screen()); break;
    case Command::save_picture: save_picture(); break;
    case Command::show_image: show_image(order.index); break;
    case Command::help: state_.shows_help = !state_.shows_help; break;
    case Command::panel: state_.shows_panel = !state_.shows_panel; break;
    case Command::quit: is_ended_ = true; break;
    }
    presents_ = 3;
}

void Session::obey(const PanelOrders& orders)
{
    for (const Order& order : orders.orders)
        obey(order);
    if (orders.settings_changed) {
        needs_plan_ = true;
        refresh_controls();
    }
    if (orders.resets_camera && scene_)
        reset_camera();
    if (orders.saves_preset)
        save_preset();
    if (orders.saves_graph)
        save_graph();
    if (orders.closes_answer)
        state_.probed.reset();
}

void Session::pick_stack(size_t index)
{
    if (index >= state_.stacks.size())
        return;
    state_.current = index;
    const std::string& name = state_.stack().name;
    state_.preset_file = name + ".preset.json";
    state_.graph_file = name + ".edited.graph.json";
    state_.probed.reset();
    window_->set_title(fmt::format("{} – passgraph", name));
    refresh_controls();
    needs_plan_ = true;
}

void Session::show_image(int index)
{
    if (index > static_cast<int>(state_.images.size()))
        return;
    Stack& stack = state_.stack();
    stack.shown = index == 0 ? "" : state_.images[static_cast<size_t>(index - 1)];
    say(index == 0 ? "the output" : fmt::format("{}: {}", index, stack.shown));
    needs_plan_ = true;
}

void Session::save_picture()
{
    if (!stage_.shown()) {
        say("there is no picture yet");
        return;
    }
    if (saving_.valid())
        saving_.wait(); // one after the other, or two would take the same name
    Result<Picture> picture = stage_.presenter().read(*stage_.shown());
    if (!picture) {
        state_.mistakes.saving = picture.error();
        return;
    }
    const Stack& stack = state_.stack();
    const std::string name = stack.shown.empty() ? stack.name : stack.name + "_" + without_dots(stack.shown);
    // Compressing takes a frame's time or two: not in the window's.
    const auto write = [picture = std::move(*picture), file = free_file(options_.pictures, name)]() -> Result<std::string> {
        if (const Result<void> written = write_picture(file, picture); !written)
            return tl::unexpected(written.error());
        return file;
    };
    saving_ = std::async(std::launch::async, write);
}

void Session::take_saved()
{
    if (!saving_.valid() || saving_.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
        return;
    const Result<std::string> saved = saving_.get();
    keep_saving_errors(saved ? Errors{} : saved.error());
    if (saved)
        say(fmt::format("saved {}", *saved));
}

void Session::keep_saving_errors(Errors errors)
{
    const Errors before = std::exchange(state_.mistakes.saving, std::move(errors));
    tell(before, state_.mistakes.saving);
}

void Session::save_preset()
{
    std::vector<PassArguments::Setting> settings;
    for (const auto& [place, setting] : state_.stack().settings)
        settings.push_back(setting);
    const Result<void> written = write_text_file(state_.preset_file, preset_text(settings));
    keep_saving_errors(written ? Errors{} : written.error());
    if (written)
        say(fmt::format("saved {} with {} values", state_.preset_file, settings.size()));
}

void Session::save_graph()
{
    const Stack& stack = state_.stack();
    const Result<std::string> text = read_text_file(stack.file);
    const Result<std::string> edited = text ? with_settings(*text, stack.file, stack.settings, *stack.description, *state_.library) : text;
    const Result<void> written = edited ? write_text_file(state_.graph_file, *edited) : Result<void>(tl::unexpected(edited.error()));
    keep_saving_errors(written ? Errors{} : written.error());
    if (written)
        say(fmt::format("saved {}", state_.graph_file));
}

} // namespace passgraph::tool::view
