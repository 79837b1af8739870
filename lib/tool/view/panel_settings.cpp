// A widget for each control.
#include <array>
#include <cfloat>
#include <cmath>

#include <fmt/format.h>
#include <imgui.h>

#include "tool/view/panel.hpp"

namespace passgraph::tool::view {
namespace {

bool is_bounded(const Control& control) { return std::isfinite(control.lowest) && std::isfinite(control.highest); }

/// A slider of a wide range cannot be set to a small value: such a parameter is dragged from where it is.
bool is_slid(const Control& control)
{
    if (!is_bounded(control))
        return false;
    const double scale = std::max(std::abs(control.original.v[0]), 1e-3 * (control.highest - control.lowest));
    return control.is_logarithmic || control.highest - control.lowest <= 64.0 * std::max(scale, 1.0);
}

std::string format_of(const Control& control)
{
    const std::string unit = control.unit.empty() || control.unit == "1" ? "" : " " + control.unit;
    std::string escaped;
    for (const char c : unit)
        escaped += c == '%' ? "%%" : std::string(1, c);
    return "%.4g" + escaped;
}

bool edit_floats(const Control& control, Value& value)
{
    std::array<float, 4> numbers{};
    for (size_t i = 0; i < numbers.size(); ++i)
        numbers[i] = static_cast<float>(value.v[i]);
    const auto low = static_cast<float>(std::max(control.lowest, -3e38));
    const auto high = static_cast<float>(std::min(control.highest, 3e38));
    const std::string format = format_of(control);
    ImGuiSliderFlags flags = ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoRoundToFormat;
    bool is_changed = false;
    if (control.kind == Control::Kind::color)
        is_changed = ImGui::ColorEdit3("##value", numbers.data(), ImGuiColorEditFlags_Float | ImGuiColorEditFlags_HDR);
    else if (is_slid(control))
        is_changed = ImGui::SliderScalarN("##value", ImGuiDataType_Float, numbers.data(), control.components, &low, &high, format.c_str(),
                                          flags | (control.is_logarithmic ? ImGuiSliderFlags_Logarithmic : 0));
    else {
        const float speed = static_cast<float>(std::max(std::abs(value.v[0]), 0.05) * 0.01);
        is_changed = ImGui::DragScalarN("##value", ImGuiDataType_Float, numbers.data(), control.components, speed, &low,
                                        &high, format.c_str(), flags);
    }
    for (size_t i = 0; i < numbers.size(); ++i)
        value.v[i] = static_cast<double>(numbers[i]);
    return is_changed;
}

bool edit_whole(const Control& control, Value& value)
{
    int number = static_cast<int>(value.v[0]);
    const std::string format = control.unit.empty() ? "%d" : "%d " + control.unit;
    const bool is_changed =
        is_slid(control) ? ImGui::SliderInt("##value", &number, static_cast<int>(control.lowest),
                                            static_cast<int>(control.highest), format.c_str(),
                                            ImGuiSliderFlags_AlwaysClamp)
                         : ImGui::DragInt("##value", &number, 0.1f);
    value.v[0] = number;
    return is_changed;
}

bool edit_item(const Control& control, Value& value)
{
    const auto current = static_cast<size_t>(value.v[0]);
    bool is_changed = false;
    if (!ImGui::BeginCombo("##value", control.items[current].c_str()))
        return false;
    for (size_t i = 0; i < control.items.size(); ++i)
        if (ImGui::Selectable(control.items[i].c_str(), i == current) && i != current) {
            value = Value(static_cast<double>(i));
            is_changed = true;
        }
    ImGui::EndCombo();
    return is_changed;
}

bool edit(const Control& control, Value& value)
{
    switch (control.kind) {
    case Control::Kind::whole: return edit_whole(control, value);
    case Control::Kind::item: return edit_item(control, value);
    case Control::Kind::flag: {
        bool is_on = value.v[0] != 0.0;
        const bool is_changed = ImGui::Checkbox("##value", &is_on);
        value = Value(is_on ? 1.0 : 0.0);
        return is_changed;
    }
    default: return edit_floats(control, value);
    }
}

void draw_control(Control& control, Settings& settings, PanelOrders& orders)
{
    ImGui::PushID(control.place.c_str());
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(control.label.c_str());
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("%s", control.help.c_str());
    ImGui::SameLine(124.0f);
    const bool is_changed_before = settings.contains(control.place);
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - (is_changed_before ? 30.0f : 0.0f));
    Value value = control.value;
    if (edit(control, value)) {
        const Value fit = fitted(control, value);
        if (!(fit == control.value)) {
            control.value = fit;
            settings[control.place] = setting_of(control, fit);
            orders.settings_changed = true;
        }
    }
    if (is_changed_before) {
        ImGui::SameLine(0.0f, 4.0f);
        if (ImGui::Button("x", {26.0f, 0.0f})) {
            settings.erase(control.place);
            orders.settings_changed = true;
        }
        if (ImGui::IsItemHovered())
            ImGui::SetTooltip("back to what the graph file says");
    }
    ImGui::PopID();
}

} // namespace

void draw_settings(ViewState& state, PanelOrders& orders)
{
    for (PassControls& pass : state.controls) {
        const bool is_open = ImGui::TreeNodeEx(pass.name.c_str(), ImGuiTreeNodeFlags_DefaultOpen | ImGuiTreeNodeFlags_SpanAvailWidth);
        if (ImGui::IsItemHovered())
            ImGui::SetTooltip("%s", pass.summary.c_str());
        if (pass.name != pass.pass) {
            ImGui::SameLine();
            ImGui::TextDisabled("%s", pass.pass.c_str());
        }
        if (!is_open)
            continue;
        std::string group;
        for (Control& control : pass.controls) {
            if (!control.is_visible)
                continue;
            if (control.group != group)
                ImGui::TextDisabled("%s", control.group.c_str());
            group = control.group;
            draw_control(control, state.stack().settings, orders);
        }
        ImGui::TreePop();
    }
    if (!state.stack().settings.empty() && ImGui::Button("reset all")) {
        state.stack().settings.clear();
        orders.settings_changed = true;
    }
}

} // namespace passgraph::tool::view
