// Fonts, spacing and colors of the user interface.
#include "context/theme.hpp"

#include <filesystem>

#include <imgui.h>

namespace passgraph::context_kinds {
namespace {

void add_font(const std::vector<std::string>& files, float pixels)
{
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    static constexpr ImWchar kLetters[] = {0x0020, 0x00ff, 0x2010, 0x2027, 0}; // Latin, dashes and dots
    for (const std::string& file : files) {
        std::error_code failed; // ImGui asserts that the file is there
        if (std::filesystem::is_regular_file(file, failed) && atlas.AddFontFromFileTTF(file.c_str(), pixels, nullptr, kLetters) != nullptr)
            return;
    }
    atlas.AddFontDefault();
}

void set_spacing(ImGuiStyle& style)
{
    style.WindowPadding = {12.0f, 10.0f};
    style.FramePadding = {7.0f, 3.0f};
    style.ItemSpacing = {8.0f, 6.0f};
    style.ItemInnerSpacing = {6.0f, 4.0f};
    style.IndentSpacing = 14.0f;
    style.ScrollbarSize = 11.0f;
    style.GrabMinSize = 9.0f;
    style.WindowRounding = 6.0f;
    style.FrameRounding = 4.0f;
    style.GrabRounding = 4.0f;
    style.ScrollbarRounding = 6.0f;
    style.WindowBorderSize = 0.0f;
    style.WindowTitleAlign = {0.0f, 0.5f};
    style.DisabledAlpha = 0.45f;
}

void set_colors(ImGuiStyle& style)
{
    ImGui::StyleColorsDark(&style);
    const ImVec4 accent{0.93f, 0.62f, 0.27f, 1.0f}; // the lantern's
    const auto faded = [&](float alpha) { return ImVec4(accent.x, accent.y, accent.z, alpha); };
    const auto grey = [](float light, float alpha) { return ImVec4(light, light, light * 1.08f, alpha); };
    auto& colors = style.Colors;
    colors[ImGuiCol_Text] = grey(0.90f, 1.0f);
    colors[ImGuiCol_TextDisabled] = grey(0.55f, 1.0f);
    colors[ImGuiCol_WindowBg] = grey(0.085f, 0.94f);
    colors[ImGuiCol_PopupBg] = grey(0.10f, 0.98f);
    colors[ImGuiCol_TitleBg] = colors[ImGuiCol_TitleBgActive] = grey(0.06f, 1.0f);
    colors[ImGuiCol_FrameBg] = grey(0.17f, 1.0f);
    colors[ImGuiCol_FrameBgHovered] = grey(0.22f, 1.0f);
    colors[ImGuiCol_FrameBgActive] = grey(0.26f, 1.0f);
    colors[ImGuiCol_Button] = grey(0.20f, 1.0f);
    colors[ImGuiCol_ButtonHovered] = faded(0.45f);
    colors[ImGuiCol_ButtonActive] = faded(0.70f);
    colors[ImGuiCol_Header] = grey(0.15f, 1.0f);
    colors[ImGuiCol_HeaderHovered] = grey(0.22f, 1.0f);
    colors[ImGuiCol_HeaderActive] = grey(0.26f, 1.0f);
    colors[ImGuiCol_SliderGrab] = faded(0.80f);
    colors[ImGuiCol_SliderGrabActive] = accent;
    colors[ImGuiCol_CheckMark] = accent;
    colors[ImGuiCol_Separator] = grey(0.22f, 1.0f);
    colors[ImGuiCol_ScrollbarBg] = grey(0.0f, 0.0f);
    colors[ImGuiCol_ScrollbarGrab] = grey(0.28f, 1.0f);
    colors[ImGuiCol_TextSelectedBg] = faded(0.35f);
    colors[ImGuiCol_PlotHistogram] = faded(0.75f);
}

} // namespace

void set_theme(const WindowOptions& options)
{
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr; // no file is left behind
    add_font(options.fonts, options.font_pixels);
    add_font(options.mono_fonts, options.font_pixels * 0.86f);
    set_spacing(ImGui::GetStyle());
    set_colors(ImGui::GetStyle());
}

} // namespace passgraph::context_kinds
