// The panel at the right: stack, costs, settings, images, plan, saving.
#include "tool/view/panel.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

namespace passgraph::tool::view {
namespace {

constexpr float kPanelWidth = 352.0f;

void draw_stacks(ViewState& state, PanelOrders& orders)
{
    constexpr std::string_view kKeys = "ZXC";
    for (size_t i = 0; i < state.stacks.size(); ++i) {
        const bool is_current = i == state.current;
        if (i > 0)
            ImGui::SameLine();
        if (is_current)
            ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
        const std::string label = i < kKeys.size() ? fmt::format("{}  {}", kKeys[i], state.stacks[i].name) : state.stacks[i].name;
        if (ImGui::Button(label.c_str()))
            orders.orders.push_back({Command::pick_stack, static_cast<int>(i)});
        if (is_current)
            ImGui::PopStyleColor();
        if (ImGui::IsItemHovered() && state.stacks[i].description)
            ImGui::SetTooltip("%s\n%s", state.stacks[i].file.c_str(), state.stacks[i].description->summary.c_str());
    }
}

void draw_saving(ViewState& state, PanelOrders& orders)
{
    const auto row = [](const char* label, std::string& file, const char* help) {
        ImGui::PushID(label);
        ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - 88.0f);
        ImGui::InputText("##file", &file);
        ImGui::SameLine();
        const bool is_pressed = ImGui::Button(label, {80.0f, 0.0f});
        if (ImGui::IsItemHovered())
            ImGui::SetTooltip("%s", help);
        ImGui::PopID();
        return is_pressed;
    };
    orders.saves_preset |= row("preset", state.preset_file, "Writes what was changed as a preset: for --preset of view, render and bench");
    orders.saves_graph |= row("graph", state.graph_file, "Writes the graph file with what was changed in it; comments stay");
    if (ImGui::Button("picture  P"))
        orders.orders.push_back({Command::save_picture});
    ImGui::SameLine();
    if (ImGui::Button("reset camera"))
        orders.resets_camera = true;
}

} // namespace

float Surface::free_width(const ViewState& state) const
{
    return static_cast<float>(width) - (state.shows_panel ? kPanelWidth + 8.0f : 0.0f);
}

PanelOrders draw_interface(ViewState& state, const Stage& stage, const Inspector& inspector, const Surface& surface)
{
    PanelOrders orders;
    const bool had_thumbnails = std::exchange(state.shows_thumbnails, false);
    if (state.shows_panel) {
        const float width = std::min(kPanelWidth, static_cast<float>(surface.width) - 16.0f);
        ImGui::SetNextWindowPos({static_cast<float>(surface.width) - width - 8.0f, 8.0f});
        ImGui::SetNextWindowSizeConstraints({width, 0.0f}, {width, static_cast<float>(surface.height) - 16.0f});
        ImGui::SetNextWindowSize({width, 0.0f});
        constexpr auto kFlags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                ImGuiWindowFlags_NoSavedSettings;
        if (ImGui::Begin("panel", nullptr, kFlags)) {
            draw_stacks(state, orders);
            ImGui::Spacing();
            draw_costs(stage);
            if (ImGui::CollapsingHeader("Settings", ImGuiTreeNodeFlags_DefaultOpen))
                draw_settings(state, orders);
            if (ImGui::CollapsingHeader("Images", had_thumbnails ? ImGuiTreeNodeFlags_DefaultOpen : 0)) {
                state.shows_thumbnails = true;
                draw_images(state, inspector, orders);
            }
            if (ImGui::CollapsingHeader("Plan"))
                draw_plan(stage);
            if (ImGui::CollapsingHeader("Save"))
                draw_saving(state, orders);
            ImGui::TextDisabled("H help    Tab hides this panel");
        }
        ImGui::End();
    }
    draw_answer(state, inspector, surface, orders);
    draw_mistakes(state, surface);
    draw_notice(state, surface);
    if (!stage.is_ready())
        draw_start(stage, surface);
    if (state.shows_help)
        draw_help(state, surface);
    return orders;
}

MonoFont::MonoFont() { ImGui::PushFont(ImGui::GetIO().Fonts->Fonts[1]); }
MonoFont::~MonoFont() { ImGui::PopFont(); }

} // namespace passgraph::tool::view
