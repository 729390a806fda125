#include "window/theme.h"

#include <imgui.h>

namespace penumbra {

namespace {

ImVec4 grey(float level, float alpha = 1) { return {level, level, level * 1.02f, alpha}; }

/// `t` runs from the panels' background to the text.
struct Ramp {
    float background, text;
    ImVec4 at(float t, float alpha = 1) const { return grey(background + t * (text - background), alpha); }
};

} // namespace

void set_theme(Theme theme, float text_height) {
    ImGuiStyle style;
    const float em = text_height;
    style.WindowPadding = {0.75f * em, 0.45f * em};
    style.FramePadding = {0.5f * em, 0.22f * em};
    style.ItemSpacing = {0.5f * em, 0.3f * em};
    style.ItemInnerSpacing = {0.4f * em, 0.3f * em};
    style.ScrollbarSize = 0.7f * em;
    style.GrabMinSize = 0.6f * em;
    style.WindowRounding = style.ChildRounding = 0;
    style.FrameRounding = style.GrabRounding = style.PopupRounding = 0.2f * em;
    style.WindowBorderSize = 0;
    style.WindowMinSize = {1, 1}; // the bars are lower than the usual one
    style.PopupBorderSize = 1;
    style.DisabledAlpha = 0.4f;

    const bool dark = theme == Theme::dark;
    const Ramp ramp = dark ? Ramp{0.105f, 0.90f} : Ramp{0.94f, 0.10f};
    const ImVec4 accent = dark ? ImVec4{0.93f, 0.72f, 0.33f, 1} : ImVec4{0.72f, 0.45f, 0.02f, 1};
    const ImVec4 on = dark ? ImVec4{0.42f, 0.33f, 0.16f, 1} : ImVec4{0.96f, 0.83f, 0.56f, 1};
    ImVec4 *c = style.Colors;
    dark ? ImGui::StyleColorsDark(&style) : ImGui::StyleColorsLight(&style);
    c[ImGuiCol_Text] = ramp.at(1);
    c[ImGuiCol_TextDisabled] = ramp.at(0.62f);
    c[ImGuiCol_WindowBg] = ramp.at(0);
    c[ImGuiCol_PopupBg] = ramp.at(dark ? 0.05f : -0.05f);
    c[ImGuiCol_MenuBarBg] = ramp.at(0.03f);
    c[ImGuiCol_Border] = ramp.at(0.2f);
    c[ImGuiCol_FrameBg] = c[ImGuiCol_Button] = ramp.at(0.09f);
    c[ImGuiCol_FrameBgHovered] = c[ImGuiCol_ButtonHovered] = ramp.at(0.17f);
    c[ImGuiCol_FrameBgActive] = ramp.at(0.22f);
    c[ImGuiCol_ButtonActive] = on;
    c[ImGuiCol_Header] = on;
    c[ImGuiCol_HeaderHovered] = c[ImGuiCol_HeaderActive] = ramp.at(0.17f);
    c[ImGuiCol_CheckMark] = c[ImGuiCol_SliderGrabActive] = accent;
    c[ImGuiCol_SliderGrab] = ramp.at(0.38f);
    c[ImGuiCol_TitleBg] = c[ImGuiCol_TitleBgActive] = ramp.at(0.09f);
    c[ImGuiCol_Separator] = ramp.at(0.15f);
    c[ImGuiCol_NavHighlight] = accent;
    ImGui::GetStyle() = style;
}

} // namespace penumbra
