// At the right of the panes: the filter microscope, the shelf of hard cases, or what accuracy costs.
#include "panels/controls.h"
#include "panels/panels.h"

namespace penumbra {

void draw_inspector(AppState &state, const WindowRect &rect, const Fonts &fonts) {
    if (state.inspector == Inspector::none)
        return;
    begin_panel("inspector", rect);
    const float third = (ImGui::GetContentRegionAvail().x - 2) / 3;
    action_button(state, "view.filters", "Filters", {third, 0});
    ImGui::SameLine(0, 1);
    action_button(state, "view.hard_cases", nullptr, {third, 0});
    ImGui::SameLine(0, 1);
    action_button(state, "view.cost", "Cost", {third, 0});
    if (state.inspector == Inspector::filters)
        draw_microscope(state);
    else if (state.inspector == Inspector::hard_cases)
        draw_hard_cases(state);
    else
        draw_cost(state, fonts);
    ImGui::End();
}

} // namespace penumbra
