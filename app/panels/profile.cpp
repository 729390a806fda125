// Below the panes: the radiosity along the line, and the line in the panes.
#include "panels/controls.h"
#include "panels/panels.h"
#include "plot/draw_list_canvas.h"
#include "render/profile_mark.h"

namespace penumbra {

void draw_profile_panel(AppState &state, const WindowRect &rect, const Fonts &fonts) {
    ProfileMode &mode = state.profile;
    if (!mode.open || rect.height <= 0) {
        mode.cursor_in_plot = false;
        return;
    }
    begin_panel("profile", rect);
    if (!mode.line) {
        ImGui::PushTextWrapPos(0);
        ImGui::TextDisabled("Drag a line over a lit surface: here will stand the radiosity along it.");
        ImGui::PopTextWrapPos();
        ImGui::End();
        return;
    }
    std::string heading = "Radiosity along A\u2013B over " + mode.data.surface;
    if (mode.exact.empty())
        heading += state.truth.halted ? ";  the truth was not looked for" : ";  " + state.truth.doing + "\u2026";
    const float close = ImGui::GetWindowContentRegionMax().x - em(1.6f);
    text_that_fits(state, heading, close - em(1), "profile heading", "Profile");
    ImGui::SameLine(close);
    action_button(state, "view.profile", "\u00d7", {em(1.6f), 0});
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 left = ImGui::GetContentRegionAvail(), high(low.x + std::max(1.f, left.x), low.y + std::max(1.f, left.y));
    ImGui::InvisibleButton("plot", {high.x - low.x, high.y - low.y});
    state.widgets["profile plot"] = {low.x, low.y, high.x - low.x, high.y - low.y};
    DrawListCanvas canvas(*ImGui::GetWindowDrawList(), fonts);
    const PlotBox box{{rect.x, low.y}, {high.x, high.y}};
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const ProfilePlaces places = draw_profile(canvas, box, mode.data, {fonts.size, state.look.theme}, mode.cursor);
    const bool was_in_plot = mode.cursor_in_plot;
    mode.cursor_in_plot = ImGui::IsItemHovered();
    if (mode.cursor_in_plot)
        mode.cursor = places.place({mouse.x, mouse.y});
    else if (was_in_plot)
        mode.cursor.reset();
    ImGui::End();
}

void draw_profile_line(const AppState &state, ImDrawList &list, const Arrangement &arrangement, const Fonts &fonts) {
    const ProfileMode &mode = state.profile;
    if (!mode.open || !mode.line)
        return;
    for (std::size_t i = 0; i < arrangement.place.size(); ++i) {
        const WindowRect &pane = arrangement.place[i];
        draw_profile_mark(list, fonts, {pane.x, pane.y}, {pane.x + pane.width, pane.y + pane.height},
                          state.camera_of(static_cast<int>(i)), *mode.line, mode.cursor);
    }
}

} // namespace penumbra
