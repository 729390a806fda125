// The mouse in a pane: orbit, pan, zoom, pivot.
#pragma once

#include "app_state.h"

namespace penumbra {

/// A point of a pane as the camera counts: [-1, 1] from the left and from the bottom.
struct FramePoint {
    double x = 0, y = 0;
};
FramePoint frame_point(const WindowRect &pane, double mouse_x, double mouse_y);

/// What the mouse is over in the pane: the surface point, or else the point of the view ray as far away as the target.
glm::dvec3 point_under(const Camera &camera, const Snapshot *snapshot, double aspect, const FramePoint &at);

/// A drag of dx, dy pixels (y down) in the active pane, of `height` pixels.
void orbit_by(AppState &state, double dx, double dy, double height);
void pan_by(AppState &state, double dx, double dy, double height);
/// One notch of the wheel upward is 1.
void zoom_by(AppState &state, int pane, double notches, const glm::dvec3 &point);

} // namespace penumbra
