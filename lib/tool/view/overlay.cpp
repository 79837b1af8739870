// What lies over the picture beside the panel: help, mistakes, a passing notice, and the values at a pixel.
#include <algorithm>

#include <fmt/format.h>
#include <imgui.h>

#include "tool/view/panel.hpp"

namespace passgraph::tool::view {
namespace {

constexpr auto kStill = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                        ImGuiWindowFlags_NoSavedSettings |
                        ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing;

std::string values_text(const ProbedValue& probed)
{
    std::string text;
    for (const float value : probed.values)
        text += fmt::format("{:>10.4g}", value);
    return text;
}

} // namespace

Errors Mistakes::all() const
{
    Errors all;
    for (const Errors* errors : {&passes, &scene, &plan, &frame, &saving})
        all.insert(all.end(), errors->begin(), errors->end());
    return all;
}

void draw_help(const ViewState& state, const Surface& surface)
{
    std::vector<std::string> names;
    for (const Stack& stack : state.stacks)
        names.push_back(stack.name);
    ImGui::SetNextWindowPos({surface.free_width(state) * 0.5f, static_cast<float>(surface.height) * 0.5f}, 0, {0.5f, 0.5f});
    ImGui::SetNextWindowFocus();
    if (ImGui::Begin("help", nullptr, kStill | ImGuiWindowFlags_NoInputs)) {
        for (const HelpLine& line : help_lines(names)) {
            ImGui::TextColored(ImGui::GetStyleColorVec4(ImGuiCol_CheckMark), "%s", line.keys.c_str());
            ImGui::SameLine(86.0f);
            ImGui::TextUnformatted(line.text.c_str());
        }
        ImGui::Spacing();
        ImGui::TextDisabled("Passes, graphs and the scene are read again as soon as they are saved.");
    }
    ImGui::End();
}

void draw_mistakes(const ViewState& state, const Surface& surface)
{
    const Errors errors = state.mistakes.all();
    if (errors.empty())
        return;
    const float width = std::min(760.0f, surface.free_width(state) - 16.0f);
    ImGui::SetNextWindowPos({8.0f, 8.0f});
    ImGui::SetNextWindowSizeConstraints({std::min(width, 220.0f), 0.0f}, {width, static_cast<float>(surface.height) - 16.0f});
    ImGui::PushStyleColor(ImGuiCol_WindowBg, ImVec4(0.24f, 0.05f, 0.05f, 0.93f));
    if (ImGui::Begin("mistakes", nullptr, kStill | ImGuiWindowFlags_NoInputs)) {
        ImGui::TextUnformatted("This does not work yet; what worked before runs on:");
        const MonoFont mono;
        ImGui::PushTextWrapPos(width - 24.0f);
        for (size_t i = 0; i < std::min<size_t>(errors.size(), 6); ++i)
            ImGui::TextUnformatted(to_text(errors[i]).c_str());
        ImGui::PopTextWrapPos();
        if (errors.size() > 6)
            ImGui::TextDisabled("and %zu more, on the terminal", errors.size() - 6);
    }
    ImGui::End();
    ImGui::PopStyleColor();
}

void draw_start(const Stage& stage, const Surface& surface)
{
    ImGui::SetNextWindowPos({static_cast<float>(surface.width) * 0.5f, static_cast<float>(surface.height) * 0.5f}, 0, {0.5f, 0.5f});
    if (ImGui::Begin("start", nullptr, kStill | ImGuiWindowFlags_NoInputs)) {
        ImGui::TextUnformatted(stage.has_scene() ? "compiling the passes" : "reading the scene");
        ImGui::ProgressBar(stage.progress(), {180.0f, 6.0f}, "");
    }
    ImGui::End();
}

void draw_notice(const ViewState& state, const Surface& surface)
{
    if (state.notice.empty() || surface.now >= state.notice_until)
        return;
    ImGui::SetNextWindowPos({8.0f, static_cast<float>(surface.height) - 8.0f}, 0, {0.0f, 1.0f});
    if (ImGui::Begin("notice", nullptr, kStill | ImGuiWindowFlags_NoInputs))
        ImGui::TextUnformatted(state.notice.c_str());
    ImGui::End();
}

void draw_answer(ViewState& state, const Inspector& inspector, const Surface& surface, PanelOrders& orders)
{
    if (!state.probed)
        return;
    const auto& [u, v] = *state.probed;
    const Presenter::Place place = Presenter::place_of(inspector.picture_extent(), {surface.width, surface.height});
    const float x = static_cast<float>(place.x + u * place.extent.width);
    const float y = static_cast<float>(surface.height - place.y - v * place.extent.height);
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    draw.AddCircle({x, y}, 6.0f, IM_COL32(0, 0, 0, 200), 0, 3.0f);
    draw.AddCircle({x, y}, 6.0f, IM_COL32(255, 255, 255, 255), 0, 1.4f);
    // Above or below the place, where there is room; the size is that of the frame before.
    const auto& [width, height] = state.answer_size;
    const bool is_low = y > static_cast<float>(surface.height) * 0.5f;
    const float right = std::max(surface.free_width(state) - width - 8.0f, 8.0f);
    const float bottom = std::max(static_cast<float>(surface.height) - height - 8.0f, 8.0f);
    ImGui::SetNextWindowPos({std::clamp(x - width * 0.5f, 8.0f, right), std::clamp(is_low ? y - height - 14.0f : y + 14.0f, 8.0f, bottom)});
    if (ImGui::Begin("values", nullptr, kStill)) {
        const MonoFont mono;
        if (inspector.is_asked() && inspector.answer().empty())
            ImGui::TextDisabled("reading the values…");
        for (const ProbedValue& probed : inspector.answer()) {
            ImGui::TextUnformatted(probed.image.c_str());
            ImGui::SameLine(150.0f);
            ImGui::TextDisabled("%-10s %4d,%4d", std::string(info(probed.signal).name).c_str(), probed.x, probed.y);
            ImGui::SameLine(300.0f);
            ImGui::TextUnformatted(values_text(probed).c_str());
        }
        if (!inspector.answer().empty() && ImGui::SmallButton("close"))
            orders.closes_answer = true;
        state.answer_size = {ImGui::GetWindowWidth(), ImGui::GetWindowHeight()};
    }
    ImGui::End();
}

} // namespace passgraph::tool::view
