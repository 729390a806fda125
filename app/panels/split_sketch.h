// The element that was split and its pieces: small in the inspector, and where they lie in the panes.
#pragma once

#include "app_state.h"

#include <imgui.h>

namespace penumbra {

/// Quarter turns after which a drawing in the surface's frame stands most nearly as the camera sees it.
Eigen::Matrix2d turn_to_view(const Camera &camera, const SnapshotSurface &surface);

/// At the cursor, fitted into the square. Returns the piece that was clicked, or -1.
int draw_split_sketch(AppState &state, const SplitFilters &filters, int chosen, float side);
/// Over a pane: the outlines, the chosen piece standing out.
void draw_split_outline(const AppState &state, ImDrawList &list, const WindowRect &pane, const Camera &camera);

} // namespace penumbra
