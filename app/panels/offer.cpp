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
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, em(0.3f));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {em(0.9f), em(0.7f)});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
    ImGui::Begin("offer", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav);
    ImGui::TextWrapped("Penumbra ended unexpectedly. Restore what it showed?");
    ImGui::Dummy({0, em(0.2f)});
    const float half = (ImGui::GetContentRegionAvail().x - em(0.5f)) / 2;
    action_button(state, "file.restore", "Restore", {half, 0});
    ImGui::SameLine(0, em(0.5f));
    action_button(state, "file.discard", "Discard", {half, 0});
    ImGui::End();
    ImGui::PopStyleVar(3);
}

} // namespace penumbra
