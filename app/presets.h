// Layouts for an occasion.
#pragma once

#include "app_state.h"

namespace penumbra {

/// One pane, large text, mesh and curves, no panels.
void preset_lecture(AppState &state);
/// Uniform beside discontinuity meshing, both with the active pane's basis; the range of colours stays.
void preset_compare(AppState &state);
/// One pane with mesh, curves and links, and the inspector.
void preset_inspect(AppState &state);
/// The four strategies on a light background, no panels.
void preset_figure(AppState &state);

} // namespace penumbra
