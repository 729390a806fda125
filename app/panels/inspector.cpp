// At the right of the panes: the filter microscope, or the shelf of hard cases.
#include "panels/controls.h"
#include "panels/panels.h"

namespace penumbra {

void draw_inspector(AppState &state, const WindowRect &rect) {
    if (state.inspector == Inspector::none)
        return;
    begin_panel("inspector", rect);
    const float half = (ImGui::GetContentRegionAvail().x - 1) / 2;
    action_button(state, "view.filters", nullptr, {half, 0});
    ImGui::SameLine(0, 1);
    action_button(state, "view.hard_cases", nullptr, {half, 0});
    if (state.inspector == Inspector::filters)
        draw_microscope(state);
    else
        draw_hard_cases(state);
    ImGui::End();
}

} // namespace penumbra
