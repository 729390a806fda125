// At the right of the panes: a picked element, the filter microscope, the shelf of hard cases, what accuracy costs, or the ledger of effects.
#include "panels/controls.h"
#include "panels/panels.h"

namespace penumbra {

void draw_inspector(AppState &state, const WindowRect &rect, const Fonts &fonts) {
    if (state.inspector == Inspector::none)
        return;
    begin_panel("inspector", rect);
    ButtonRow tabs({"Element", "Filters", "Hard cases", "Cost", "Effects"});
    action_button(state, "view.inspector", "Element", tabs.next());
    action_button(state, "view.filters", "Filters", tabs.next());
    action_button(state, "view.hard_cases", "Hard cases", tabs.next());
    action_button(state, "view.cost", "Cost", tabs.next());
    action_button(state, "view.effects", "Effects", tabs.next());
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
