// An object in hand, moved with the mouse in a pane.
#pragma once

#include "panels/navigation.h"

#include <imgui.h>

namespace penumbra {

/// For the pane whose button is the last item. Returns whether the mouse holds an object, so that the view stays.
bool drag_object(AppState &state, const Snapshot *snapshot, double aspect, const FramePoint &at);

/// The outline of the object in hand.
void draw_object_outline(const AppState &state, ImDrawList &list, const WindowRect &pane, const Camera &camera);

} // namespace penumbra
