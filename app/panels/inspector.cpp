// At the right of the panes: a picked element, the filter microscope, the shelf of hard cases, what accuracy costs, or the ledger of effects.
#include "panels/controls.h"
#include "panels/panels.h"

namespace penumbra {

void draw_inspector(AppState &state, const WindowRect &rect, const Fonts &fonts) {
    if (state.inspector == Inspector::none)
        return;
    begin_panel("inspector", rect);
    const float width = ImGui::GetContentRegionAvail().x - 4;
    action_button(state, "view.inspector", "Element", {0.2f * width, 0});
    ImGui::SameLine(0, 1);
    action_button(state, "view.filters", "Filters", {0.18f * width, 0});
    ImGui::SameLine(0, 1);
    action_button(state, "view.hard_cases", nullptr, {0.27f * width, 0});
    ImGui::SameLine(0, 1);
    action_button(state, "view.cost", "Cost", {0.15f * width, 0});
    ImGui::SameLine(0, 1);
    action_button(state, "view.effects", nullptr, {0.2f * width, 0});
    if (state.inspector == Inspector::element)
        draw_element(state, fonts);
    else if (state.inspector == Inspector::filters)
        draw_microscope(state);
    else if (state.inspector == Inspector::hard_cases)
        draw_hard_cases(state);
    else if (state.inspector == Inspector::bookmarks)
        draw_bookmarks(state);
    else if (state.inspector == Inspector::objects)
        draw_objects(state);
    else if (state.inspector == Inspector::effects)
        draw_effects(state);
    else
        draw_cost(state, fonts);
    ImGui::End();
}

} // namespace penumbra
