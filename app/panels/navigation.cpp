#include "panels/navigation.h"

#include <cmath>
#include <numbers>

namespace penumbra {

FramePoint frame_point(const WindowRect &pane, double mouse_x, double mouse_y) {
    const double w = pane.width, h = pane.height;
    return {2 * (mouse_x - static_cast<double>(pane.x)) / w - 1, 1 - 2 * (mouse_y - static_cast<double>(pane.y)) / h};
}

glm::dvec3 point_under(const Camera &camera, const Snapshot *snapshot, double aspect, const FramePoint &at) {
    if (snapshot)
        if (const auto hit = pick(*snapshot, camera, aspect, at.x, at.y))
            return {hit->point.x(), hit->point.y(), hit->point.z()};
    const glm::dvec3 ray = view_ray(camera, aspect, at.x, at.y), ahead = camera.target - camera.eye;
    const double along = glm::dot(ray, glm::normalize(ahead));
    return camera.eye + ray * (glm::length(ahead) / along);
}

void orbit_by(AppState &state, double dx, double dy, double height) {
    // Half a turn for the height of the pane, as the hand expects of a ball that fills it.
    const double angle = std::numbers::pi / height;
    state.camera_moved = true;
    Camera &camera = state.camera_of(state.panes().active);
    camera = orbit(camera, -dx * angle, -dy * angle, state.orbit_pivot.value_or(camera.target));
}

void pan_by(AppState &state, double dx, double dy, double height) {
    Camera &camera = state.camera_of(state.panes().active);
    const Camera before = camera;
    state.camera_moved = true;
    camera = pan(before, dx, dy, height, state.drag_anchor.value_or(before.target));
    if (state.pivot)
        *state.pivot += camera.target - before.target;
}

void zoom_by(AppState &state, int pane, double notches, const glm::dvec3 &point) {
    state.camera_moved = true;
    state.camera_of(pane) = zoom(state.camera_of(pane), std::pow(0.87, notches), point);
}

} // namespace penumbra
