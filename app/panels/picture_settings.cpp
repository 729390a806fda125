#include "panels/controls.h"
#include "panels/panels.h"

#include <array>
#include <cstdio>

namespace penumbra {

namespace {

struct SizeChoice {
    PictureSize size;
    const char *name, *text, *tooltip;
};
constexpr std::array<SizeChoice, 4> sizes{{
    {PictureSize::panes, "picture.panes", "As the panes", "The window's own shape, at least 1920 pixels wide."},
    {PictureSize::full_hd, "picture.1920", "1920 × 1080", "Full HD: a slide."},
    {PictureSize::ultra_hd, "picture.3840", "3840 × 2160", "4K: a large screen."},
    {PictureSize::eight_k, "picture.7680", "7680 × 4320", "8K: a poster. It takes a minute or so without a graphics card."},
}};

void draw_sizes(AppState &state) {
    PictureSettings &settings = state.pictures.settings;
    field_label("Size");
    const float left = ImGui::GetCursorPosX();
    const bool narrow = ImGui::GetIO().DisplaySize.x < em(46);
    for (const SizeChoice &c : sizes) {
        if (narrow && &c == &sizes[2])
            ImGui::SetCursorPosX(left);
        else if (&c != &sizes.front())
            ImGui::SameLine();
        if (choice(state, c.name, c.text, settings.size == c.size, c.tooltip))
            settings.size = c.size;
    }
}

void draw_supersampling(AppState &state) {
    PictureSettings &settings = state.pictures.settings;
    field_label("Smoothing");
    for (int n = 1; n <= 4; ++n) {
        if (n > 1)
            ImGui::SameLine();
        char name[32], text[16];
        std::snprintf(name, sizeof name, "picture.supersample %d", n);
        std::snprintf(text, sizeof text, "%d ×", n);
        if (choice(state, name, text, settings.supersample == n,
                   n == 1 ? "Four samples a pixel, as in the window."
                          : "Drawn so many times larger and averaged as light: smoother edges, for as many times as long, squared."))
            settings.supersample = n;
    }
}

} // namespace

void draw_picture_settings(AppState &state) {
    PictureMode &pictures = state.pictures;
    if (!pictures.settings_open)
        return;
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.5f * window.x, 0.3f * window.y}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::Begin("Pictures", &pictures.settings_open,
                 ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_AlwaysAutoResize);
    draw_sizes(state);
    draw_supersampling(state);
    field_label("Background");
    ImGui::Checkbox("transparent", &pictures.settings.transparent);
    mark(state, "picture.transparent");
    tooltip("Transparent", "A PNG with alpha, to be laid over a slide; words stand on plates of the background's colour.");
    field_label("Words");
    ImGui::Checkbox("labels", &pictures.settings.labels);
    mark(state, "picture.labels");
    tooltip("Labels", "Strategy and figures over each pane. The legend is a layer of its own.");
    ImGui::SameLine();
    action_check(state, "layers.legend", "legend");
    action_button(state, "file.picture");
    ImGui::SameLine();
    action_button(state, "file.copy_command");
    ImGui::End();
}

} // namespace penumbra
