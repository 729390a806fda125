// Over the panes: what a window showed that ended unexpectedly can be restored.
#include "panels/controls.h"
#include "panels/panels.h"

#include <algorithm>

namespace penumbra {

void draw_offer(AppState &state, const WindowRect &panes) {
    if (state.orphans.empty())
        return;
    const float width = std::min(em(25), panes.width - em(2));
    ImGui::SetNextWindowPos({panes.x + 0.5f * panes.width, panes.y + 0.3f * panes.height}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSize({width, 0});
    begin_card("offer");
    ImGui::TextWrapped("Penumbra ended unexpectedly. Restore what it showed?");
    ImGui::Dummy({0, em(0.2f)});
    const float half = (ImGui::GetContentRegionAvail().x - em(0.5f)) / 2;
    action_button(state, "file.restore", "Restore", {half, 0});
    ImGui::SameLine(0, em(0.5f));
    action_button(state, "file.discard", "Discard", {half, 0});
    end_card();
}

} // namespace penumbra
