#include "panels/navigation.h"

#include <cmath>
#include <numbers>

namespace penumbra {

FramePoint frame_point(const WindowRect &pane, double mouse_x, double mouse_y) {
    const double w = pane.width, h = pane.height;
    return {2 * (mouse_x - static_cast<double>(pane.x)) / w - 1, 1 - 2 * (mouse_y - static_cast<double>(pane.y)) / h};
}

glm::dvec3 point_under(const AppState &state, const Snapshot *snapshot, double aspect, const FramePoint &at) {
    const Camera &camera = state.camera;
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
    state.camera = orbit(state.camera, -dx * angle, -dy * angle, state.orbit_pivot.value_or(state.camera.target));
}

void pan_by(AppState &state, double dx, double dy, double height) {
    const Camera before = state.camera;
    state.camera_moved = true;
    state.camera = pan(before, dx, dy, height, state.drag_anchor.value_or(before.target));
    if (state.pivot)
        *state.pivot += state.camera.target - before.target;
}

void zoom_by(AppState &state, double notches, const glm::dvec3 &point) {
    state.camera_moved = true;
    state.camera = zoom(state.camera, std::pow(0.87, notches), point);
}

} // namespace penumbra
