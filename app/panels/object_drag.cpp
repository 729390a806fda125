#include "panels/object_drag.h"

#include "move_verbs.h"
#include "panels/controls.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace penumbra {

namespace {

Vec3 from_glm(const glm::dvec3 &v) { return {v.x, v.y, v.z}; }
glm::dvec3 to_glm(const Vec3 &v) { return {v.x(), v.y(), v.z()}; }

struct Touched {
    int surface = -1; ///< -1: none
    Vec3 point = Vec3::Zero();
};

/// The nearest surface under the mouse, whichever of its sides is seen.
Touched touch(const Scene &scene, const Camera &camera, double aspect, const FramePoint &at) {
    const Vec3 eye = scene.own.to_solver(from_glm(camera.eye)), way = from_glm(view_ray(camera, aspect, at.x, at.y));
    double nearest = std::numeric_limits<double>::infinity();
    Touched out;
    for (int s = 0; s < scene.n_surfaces(); ++s) {
        const Surface &surface = scene.surface(SurfaceId(s));
        const double t = -surface.frame.height(eye) / surface.frame.normal.dot(way);
        if (!(t > 0) || t >= nearest)
            continue;
        const Vec3 x = eye + t * way;
        const Vec2 p = surface.frame.to_plane(x);
        if (std::ranges::none_of(surface.parts, [&](const Polygon &part) { return contains(part, p); }))
            continue;
        nearest = t;
        out = {s, scene.own.to_own(x)};
    }
    return out;
}

/// Where the mouse has what it holds: level with where it was grabbed, or, with Shift, above or below that.
std::optional<Vec3> held_at(const Scene &scene, const Camera &camera, double aspect, const FramePoint &at, const Vec3 &grabbed) {
    const Vec3 eye = from_glm(camera.eye), way = from_glm(view_ray(camera, aspect, at.x, at.y)), up = scene.up.normalized();
    if (!ImGui::GetIO().KeyShift) {
        const double slope = way.dot(up), t = (grabbed - eye).dot(up) / slope;
        if (std::abs(slope) < 0.02 || !(t > 0))
            return std::nullopt;
        return eye + t * way;
    }
    // The point of the upright line that is nearest to the ray.
    const Vec3 across = way - way.dot(up) * up;
    if (across.norm() < 0.02)
        return std::nullopt;
    const double t = (grabbed - eye).dot(across) / across.squaredNorm();
    const Vec3 x = eye + t * way;
    return grabbed + (x - grabbed).dot(up) * up;
}

} // namespace

bool drag_object(AppState &state, const Snapshot *snapshot, double aspect, const FramePoint &at) {
    ObjectsMode &mode = state.objects;
    if (state.inspector != Inspector::objects || !snapshot || !state.scene) {
        mode.grabbed.reset();
        return false;
    }
    if (ImGui::IsItemActivated() && ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
        const Touched touched = touch(*state.scene, state.active_camera(), aspect, at);
        const int before = mode.chosen;
        choose_object(state, touched.surface);
        if (mode.chosen >= 0 && mode.chosen == before)
            mode.grabbed = touched.point;
    }
    const bool held = mode.grabbed.has_value(); // also in the frame in which it is let go
    if (held && ImGui::IsItemActive() && ImGui::IsMouseDragging(ImGuiMouseButton_Left, 0))
        if (const auto now = held_at(*state.scene, state.active_camera(), aspect, at, *mode.grabbed); now && *now != *mode.grabbed) {
            ObjectMove move = move_in_hand(state);
            move.offset += *now - *mode.grabbed;
            mode.grabbed = *now;
            move_object(state, move);
        }
    if (!ImGui::IsItemActive())
        mode.grabbed.reset();
    return held;
}

void draw_object_outline(const AppState &state, ImDrawList &list, const WindowRect &pane, const Camera &camera) {
    if (state.inspector != Inspector::objects || state.objects.chosen < 0 || !state.scene)
        return;
    const Scene &scene = *state.scene;
    const double aspect = static_cast<double>(pane.width / pane.height);
    for (const int s : object_surfaces(scene, SurfaceId(state.objects.chosen))) {
        ImVector<ImVec2> corners;
        for (const Vec3 &x : scene.surface(SurfaceId(s)).corners)
            if (const auto p = place_in_frame(camera, aspect, to_glm(scene.own.to_own(x))))
                corners.push_back({pane.x + 0.5f * pane.width * (1 + static_cast<float>(p->x)),
                                   pane.y + 0.5f * pane.height * (1 - static_cast<float>(p->y))});
        list.PushClipRect({pane.x, pane.y}, {pane.x + pane.width, pane.y + pane.height}, true);
        list.AddPolyline(corners.Data, corners.Size, ImGui::GetColorU32(ImGuiCol_CheckMark), ImDrawFlags_Closed, 0.12f * em());
        list.PopClipRect();
    }
}

} // namespace penumbra
