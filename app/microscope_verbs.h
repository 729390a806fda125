// Looking at the push and pull filters of a split.
#pragma once

#include "app_state.h"

namespace penumbra {

/// Opens this side of the inspector, or closes it when it is open.
void toggle_inspector(AppState &state, Inspector inspector);
/// Looks at the split that made the patch there, and at the piece that the patch is.
void pick_split(AppState &state, const SurfacePoint &at);
/// By so many splits outward from the patch; the piece is the one that holds the point.
void step_outward(AppState &state, int by);
/// Takes what is looked at from the active pane's snapshot. Where nothing has been picked yet, the largest cut is.
void update_microscope(AppState &state);

} // namespace penumbra
