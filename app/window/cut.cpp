#include "window/cut.h"

#include <imgui.h>
#include <imgui_internal.h>

namespace penumbra {

namespace {

constexpr float slack = 1; ///< of rounding [screen coordinates]

std::string pixels(float excess) { return " by " + std::to_string(static_cast<int>(excess)); }

} // namespace

std::vector<std::string> cut_windows() {
    std::vector<std::string> all;
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    for (const ImGuiWindow *window : ImGui::GetCurrentContext()->Windows) {
        if (!window->Active || window->Hidden || (window->Flags & ImGuiWindowFlags_Tooltip))
            continue;
        const std::string name = window->Name;
        const ImRect rect = window->Rect();
        if (const bool root = window->ParentWindow == nullptr;
            root && (rect.Min.x < -slack || rect.Min.y < -slack || rect.Max.x > display.x + slack || rect.Max.y > display.y + slack))
            all.push_back(name + " reaches beyond the display");
        const ImVec2 needed = window->DC.CursorMaxPos;
        if (const float excess = needed.x - window->InnerClipRect.Max.x; excess > slack && !(window->Flags & ImGuiWindowFlags_HorizontalScrollbar))
            all.push_back(name + " is too narrow" + pixels(excess));
        // What a menu bar measures are the menus.
        const bool scrolls = !(window->Flags & (ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse)) ||
                             (window->Flags & ImGuiWindowFlags_MenuBar);
        if (const float excess = needed.y - window->InnerClipRect.Max.y; excess > slack && !scrolls)
            all.push_back(name + " is too low" + pixels(excess));
    }
    return all;
}

} // namespace penumbra
