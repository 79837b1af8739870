// Small copies of the graph's images, to be picked.
#include <algorithm>

#include <fmt/format.h>
#include <imgui.h>

#include "tool/view/panel.hpp"

namespace passgraph::tool::view {
namespace {

std::string key_of(size_t image)
{
    return image < 9 ? fmt::format("{}  ", image + 1) : image < 18 ? fmt::format("shift {}  ", image - 8) : "";
}

} // namespace

void draw_images(ViewState& state, const Inspector& inspector, PanelOrders& orders)
{
    if (inspector.thumbnails().empty())
        ImGui::TextDisabled("drawing…");
    const float width = (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x) * 0.5f - 4.0f;
    int column = 0;
    for (const Thumbnail& thumbnail : inspector.thumbnails()) {
        const auto found = std::find(state.images.begin(), state.images.end(), thumbnail.image);
        if (found == state.images.end())
            continue; // of the stack before
        const auto index = static_cast<size_t>(found - state.images.begin());
        const Extent extent = thumbnail.texture.extent;
        const float height = width * static_cast<float>(extent.height) / static_cast<float>(extent.width);
        if (column++ % 2 == 1)
            ImGui::SameLine();
        ImGui::BeginGroup();
        ImGui::PushID(thumbnail.image.c_str());
        const bool is_shown = state.stack().shown == thumbnail.image;
        if (is_shown)
            ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_SliderGrabActive));
        const auto id = reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(thumbnail.texture.id));
        // Textures start at the bottom, ImGui's pictures at the top.
        if (ImGui::ImageButton(id, {width, height}, {0.0f, 1.0f}, {1.0f, 0.0f}, 2))
            orders.orders.push_back({Command::show_image, is_shown ? 0 : static_cast<int>(index) + 1});
        if (is_shown)
            ImGui::PopStyleColor();
        if (ImGui::IsItemHovered())
            ImGui::SetTooltip("%s: %s\n%s", thumbnail.image.c_str(), std::string(info(thumbnail.signal).name).c_str(),
                              std::string(info(thumbnail.signal).meaning).c_str());
        const ImVec2 at = ImGui::GetCursorScreenPos();
        ImGui::PushClipRect(at, {at.x + width + 4.0f, at.y + 40.0f}, true);
        ImGui::TextDisabled("%s", key_of(index).c_str());
        ImGui::SameLine(0.0f, 0.0f);
        ImGui::TextUnformatted(thumbnail.image.c_str());
        ImGui::PopClipRect();
        ImGui::PopID();
        ImGui::EndGroup();
    }
}

} // namespace passgraph::tool::view
