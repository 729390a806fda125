#include "panels/controls.h"
#include "panels/panels.h"
#include "verbs.h"

#include <algorithm>
#include <vector>

namespace penumbra {

namespace {

/// Before a group of so many words and buttons: where they do not fit into the line, they begin the next.
void gap(AppState &state, const std::vector<const char *> &texts, float space) {
    float width = 0;
    for (const char *text : texts)
        width += button_width(text);
    state.tool_bar_rows += go_on(space, width);
}

void label(const char *text) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("%s", text);
    ImGui::SameLine();
}

void draw_scene_choice(AppState &state) {
    label("Scene");
    const std::string now = !state.opening.empty() ? "opening…" : state.scene ? state.scene->name : "none";
    const float needed = ImGui::CalcTextSize(now.c_str()).x + ImGui::GetFrameHeight() + em(1);
    ImGui::SetNextItemWidth(std::clamp(needed, em(11), em(16)));
    const bool open = ImGui::BeginCombo("##scene", now.c_str());
    if (!open) {
        mark(state, "scene");
        tooltip("Scene", "The bundled scenes; Open (Ctrl+O) takes files, too.");
        return;
    }
    for (const std::string &name : state.bundled_scenes) {
        if (ImGui::Selectable(name.c_str(), state.scene && state.scene->name == name))
            state.open_request = name;
        mark(state, "scene." + name);
        tooltip(name, "Opens this bundled scene.");
    }
    ImGui::EndCombo();
}

void draw_strategy_choice(AppState &state) {
    const Strategy now = state.active_strategy();
    const bool cuts = cuts_along_curves(now), constant = is_constant(now);
    gap(state, {"Meshing", "Uniform", "Discontinuity"}, em());
    label("Meshing");
    if (choice(state, "meshing.uniform", "Uniform", !cuts, "Splits a patch in four where the fit is poor."))
        set_strategy(state, strategy_of(false, constant));
    ImGui::SameLine(0, 1);
    if (choice(state, "meshing.discontinuity", "Discontinuity", cuts, "Cuts patches along shadow boundaries."))
        set_strategy(state, strategy_of(true, constant));
    gap(state, {"Basis", "Constant", "Multiwavelet", "(d)"}, em());
    label("Basis");
    if (choice(state, "basis.constant", "Constant", constant, "One value a patch."))
        set_strategy(state, strategy_of(cuts, true));
    ImGui::SameLine(0, 1);
    if (choice(state, "basis.multiwavelet", "Multiwavelet", !constant, "A polynomial on each patch."))
        set_strategy(state, strategy_of(cuts, false));
    ImGui::SameLine();
    ImGui::TextDisabled("(%s)", letter(now));
}

} // namespace

void draw_tool_bar(AppState &state, const WindowRect &rect) {
    begin_panel("tool bar", rect);
    state.tool_bar_rows = 1;
    draw_scene_choice(state);
    draw_strategy_choice(state);
    gap(state, {"Panes", "1.", "2.", "2×2", "W.", "W.", "W."}, em());
    label("Panes");
    action_button(state, "view.single", "1", {em(1.8f), 0});
    ImGui::SameLine(0, 1);
    action_button(state, "view.two", "2", {em(1.8f), 0});
    ImGui::SameLine(0, 1);
    action_button(state, "view.four", "2×2", {em(2.6f), 0});
    ImGui::SameLine(0, 1);
    action_button(state, "view.wipe", "\u25e7", {em(1.8f), 0});
    ImGui::SameLine(0, 1);
    action_button(state, "view.flip", "\u21c4", {em(1.8f), 0});
    ImGui::SameLine(0, 1);
    action_button(state, "view.difference", "\u0394", {em(1.8f), 0});
    gap(state, {"Keyhole"}, em());
    action_button(state, "view.keyhole");
    gap(state, {"Effects"}, em(0.5f));
    action_button(state, "view.effects");
    gap(state, {"Cases"}, em(0.5f));
    action_button(state, "view.hard_cases", "Cases");
    gap(state, {"Cost"}, em(0.5f));
    action_button(state, "view.cost", "Cost");
    const float help = em(1.9f), right = ImGui::GetWindowContentRegionMax().x;
    gap(state, {"?."}, em(0.5f));
    ImGui::SetCursorPosX(std::max(ImGui::GetCursorPosX(), right - help));
    action_button(state, "help.keys", "?", {help, 0});
    ImGui::End();
}

} // namespace penumbra
