// What a frame costs, and the plan in words.
#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <imgui.h>

#include "tool/view/panel.hpp"

namespace passgraph::tool::view {
namespace {

double megabytes(const Plan& plan, const Plan::Step& step)
{
    std::int64_t bytes = 0;
    const auto add = [&](int slot) {
        const Plan::Slot& row = plan.slots[static_cast<size_t>(slot)];
        bytes += static_cast<std::int64_t>(row.extent.width) * row.extent.height * bytes_per_texel(row.format);
    };
    for (const Plan::Target& target : step.targets)
        add(target.slot);
    if (step.depth_slot >= 0)
        add(step.depth_slot);
    return static_cast<double>(bytes) / (1024.0 * 1024.0);
}

/// What did not run, why, and what that saves as far as it was ever seen to run.
void draw_left_out(const Stage& stage)
{
    const Plan& plan = stage.plan();
    const auto line = [](const std::string& what, const std::string& why, double saved) {
        const std::string gain = saved > 0.0 ? fmt::format("  saves {:.1f} ms", saved) : "";
        ImGui::TextWrapped("%s", fmt::format("{}: {}{}", what, why, gain).c_str());
    };
    bool has_title = false;
    const auto title = [&] {
        if (!std::exchange(has_title, true))
            ImGui::TextDisabled("Not run");
    };
    for (size_t i = 0; i < stage.step_times().size() && i < plan.steps.size(); ++i) {
        const StepTime& time = stage.step_times()[i];
        if (!time.was_skipped)
            continue;
        title();
        line(time.step, why_skipped(plan, i, true), std::max(stage.last_drawn_ms(time.step) - time.milliseconds, 0.0));
    }
    for (const Plan::Culled& culled : plan.culled) {
        title();
        line(culled.pass, culled.reason, stage.last_drawn_ms(culled.pass));
    }
    for (const Plan::Decision& decision : plan.decisions)
        if (std::none_of(plan.culled.begin(), plan.culled.end(), [&](const Plan::Culled& culled) { return culled.pass == decision.what; })) {
            title();
            line(decision.what, decision.reason, 0.0);
        }
}

} // namespace

void draw_costs(const Stage& stage)
{
    const Plan& plan = stage.plan();
    if (!stage.is_ready())
        return;
    ImGui::Text("%.0f ms", stage.frame_ms());
    ImGui::SameLine();
    ImGui::TextDisabled("%d x %d, %zu step%s, %.1f MB", plan.extent.width, plan.extent.height, plan.steps.size(),
                        plan.steps.size() == 1 ? "" : "s",
                        static_cast<double>(plan.bytes) / (1024.0 * 1024.0));
    if (stage.is_building())
        ImGui::ProgressBar(stage.progress(), {-1.0f, 6.0f}, "");
    if (!ImGui::CollapsingHeader("Steps"))
        return;
    if (!ImGui::BeginTable("steps", 3, ImGuiTableFlags_SizingStretchProp))
        return;
    ImGui::TableSetupColumn("step", 0, 6.0f);
    ImGui::TableSetupColumn("ms", 0, 1.6f);
    ImGui::TableSetupColumn("MB", 0, 1.4f);
    const auto& times = stage.step_times();
    double longest = 1e-3;
    for (const StepTime& time : times)
        longest = std::max(longest, time.milliseconds);
    for (size_t i = 0; i < plan.steps.size() && i < times.size(); ++i) {
        const Plan::Step& step = plan.steps[i];
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(step.name.c_str());
        const std::string why = why_skipped(plan, i, times[i].was_skipped);
        if (ImGui::IsItemHovered())
            ImGui::SetTooltip("%s\n%d x %d%s%s", step.name.c_str(), step.extent.width, step.extent.height,
                              why.empty() ? "" : "\n", why.c_str());
        ImGui::TableNextColumn();
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const float width = ImGui::GetContentRegionAvail().x * static_cast<float>(std::max(times[i].milliseconds, 0.0) / longest);
        ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + width, at.y + ImGui::GetTextLineHeight()},
                                                  ImGui::GetColorU32(ImGuiCol_PlotHistogram, 0.35f), 2.0f);
        if (why.empty())
            ImGui::Text("%.1f", times[i].milliseconds);
        else
            ImGui::TextDisabled("%.1f", times[i].milliseconds);
        ImGui::TableNextColumn();
        ImGui::Text("%.1f", megabytes(plan, step));
    }
    ImGui::EndTable();
    draw_left_out(stage);
}

void draw_plan(const Stage& stage)
{
    const MonoFont mono;
    if (ImGui::BeginChild("plan", {0.0f, 260.0f}, false, ImGuiWindowFlags_HorizontalScrollbar))
        ImGui::TextUnformatted(to_text(stage.plan()).c_str());
    ImGui::EndChild();
}

} // namespace passgraph::tool::view
