// The divider of a wipe, dragged from side to side.
#include "render/divider.h"

#include "panels/controls.h"
#include "panels/panels.h"

#include <algorithm>

namespace penumbra {

void drag_divider(AppState &state, const Arrangement &arrangement) {
    if (state.layout != Layout::wipe)
        return;
    const WindowRect &place = arrangement.place[0];
    const float x = arrangement.part[1].x, reach = em(0.6f);
    const float left = std::max(place.x, x - reach), right = std::min(place.x + place.width, x + reach);
    ImGui::SetCursorScreenPos({left, place.y});
    ImGui::InvisibleButton("divider", {right - left, place.height});
    mark(state, "divider");
    if (ImGui::IsItemActive() && ImGui::IsMouseDragging(ImGuiMouseButton_Left, 0)) {
        const double share = static_cast<double>((ImGui::GetIO().MousePos.x - place.x) / place.width);
        state.wipe = std::clamp(share, 0.0, 1.0);
    }
    if (ImGui::IsItemHovered() || ImGui::IsItemActive())
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    if (!ImGui::IsItemActive())
        tooltip("Divider", "Drag it: left of it stands the first strategy, right of it the second.");
}

void draw_divider(const AppState &state, ImDrawList &list, const Arrangement &arrangement) {
    if (state.layout != Layout::wipe)
        return;
    const WindowRect &place = arrangement.place[0];
    const float x = arrangement.part[1].x;
    list.PushClipRect({place.x, place.y}, {place.x + place.width, place.y + place.height}, true);
    draw_divider(list, x, place.y, place.y + place.height, em());
    draw_divider_knob(list, x, place.y + 0.5f * place.height, em());
    list.PopClipRect();
}

} // namespace penumbra
