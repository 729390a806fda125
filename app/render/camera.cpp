#include "render/camera.h"

#include "render/surface_role.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <tuple>
#include <vector>

namespace penumbra {
namespace {

glm::dvec3 to_glm(const Vec3 &x) { return {x.x(), x.y(), x.z()}; }

struct Axes {
    glm::dvec3 right, up, forward;
};

Axes axes(const Camera &camera) {
    const glm::dvec3 forward = glm::normalize(camera.target - camera.eye);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, camera.up));
    return {right, glm::cross(right, forward), forward};
}

/// Corners of the subject; of everything when there is no such surface.
std::vector<glm::dvec3> corners_to_show(const Snapshot &snapshot, Subject subject) {
    std::vector<glm::dvec3> shown, all;
    for (const SnapshotSurface &s : snapshot.surfaces)
        for (const Vec2 &p : s.outline) {
            all.push_back(to_glm(to_space(s, p)));
            if (role(s) != (subject == Subject::lit_and_lamps ? SurfaceRole::blocker : SurfaceRole::emitter))
                shown.push_back(all.back());
        }
    return shown.empty() ? all : shown;
}

/// Direction from the room's middle to its open side, of several alike the one nearest to `front`; nothing where there
/// is no ceiling.
std::optional<glm::dvec3> open_side(const Snapshot &snapshot, const glm::dvec3 &up, const glm::dvec3 &front) {
    const std::vector<Back> back = backs(snapshot);
    struct Wall {
        glm::dvec3 inward;
        double size;
    };
    std::vector<Wall> walls;
    bool ceiling = false;
    for (std::size_t i = 0; i < snapshot.surfaces.size(); ++i) {
        const SnapshotSurface &s = snapshot.surfaces[i];
        const glm::dvec3 normal = to_glm(s.normal);
        if (back[i] != Back::hidden || role(s) != SurfaceRole::reflector)
            continue;
        ceiling |= glm::dot(normal, up) < -0.9;
        if (std::abs(glm::dot(normal, up)) < 0.1) {
            double twice_area = 0;
            for (std::size_t k = 0; k < s.outline.size(); ++k)
                twice_area += cross(s.outline[k], s.outline[(k + 1) % s.outline.size()]);
            walls.push_back({normal, twice_area});
        }
    }
    if (!ceiling || walls.empty())
        return std::nullopt;
    const auto closed = [&](const Wall &w) {
        return std::any_of(walls.begin(), walls.end(), [&](const Wall &o) { return glm::dot(w.inward, o.inward) < -0.9; });
    };
    double largest = 0;
    for (const Wall &w : walls)
        largest = std::max(largest, w.size);
    const auto worth = [&](const Wall &w) { // sizes that differ by a few percent count as alike
        return std::tuple(!closed(w), std::round(16 * w.size / largest), glm::dot(w.inward, front));
    };
    const Wall best = *std::max_element(walls.begin(), walls.end(),
                                        [&](const Wall &a, const Wall &b) { return worth(a) < worth(b); });
    return glm::normalize(best.inward - glm::dot(best.inward, up) * up);
}

} // namespace

Bounds bounds(const Snapshot &snapshot) {
    Bounds box{glm::dvec3(std::numeric_limits<double>::max()), glm::dvec3(std::numeric_limits<double>::lowest())};
    for (const SnapshotSurface &s : snapshot.surfaces)
        for (const Vec2 &p : s.outline) {
            const glm::dvec3 x = to_glm(to_space(s, p));
            box.low = glm::min(box.low, x);
            box.high = glm::max(box.high, x);
        }
    return snapshot.surfaces.empty() ? Bounds{} : box;
}

Camera default_view(const Snapshot &snapshot, double aspect, const Vec3 &up) {
    Camera camera;
    camera.up = glm::normalize(to_glm(up));
    camera.target = bounds(snapshot).centre();
    const glm::dvec3 x = std::abs(camera.up.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 right = glm::normalize(x - glm::dot(x, camera.up) * camera.up);
    const glm::dvec3 back = glm::cross(camera.up, right);
    if (const auto open = open_side(snapshot, camera.up, -back)) {
        camera.fov_y = 36;
        camera.eye = camera.target + *open;
    } else {
        camera.fov_y = 28;
        // Off the axes of the usual floor, so that its sides lie slanting in the picture.
        const double azimuth = glm::radians(-68.0), elevation = glm::radians(50.0);
        camera.eye = camera.target + std::cos(elevation) * (std::cos(azimuth) * right + std::sin(azimuth) * back) +
                     std::sin(elevation) * camera.up;
    }
    return fit(camera, snapshot, aspect);
}

Camera camera_from(const View &view, const Scene &scene) {
    return {to_glm(view.eye), to_glm(view.target), glm::normalize(to_glm(scene.up)), view.fov_degrees};
}

Camera first_view(const Scene &scene, const Snapshot &snapshot, double aspect) {
    if (!scene.view)
        return default_view(snapshot, aspect, scene.up);
    const Camera camera = camera_from(*scene.view, scene);
    constexpr double meant_for = 4.0 / 3;
    return aspect < meant_for ? zoom(camera, meant_for / aspect, camera.target) : camera;
}

Camera fit(const Camera &camera, const Snapshot &snapshot, double aspect, Subject subject) {
    const std::vector<glm::dvec3> corners = corners_to_show(snapshot, subject);
    if (corners.empty())
        return camera;
    // The frame's four sides are planes through the eye. In the camera's axes the two upright ones ask
    // |x - eye_x| <= slope (z - eye_z) of every corner: the nearest eye that fulfils both follows from the two extremes.
    const Axes a = axes(camera);
    const double margin = 0.93, slope_y = margin * std::tan(glm::radians(camera.fov_y) / 2), slope_x = slope_y * aspect;
    const auto nearest_eye = [&](const glm::dvec3 &axis, double slope) {
        double high = std::numeric_limits<double>::lowest(), low = high;
        for (const glm::dvec3 &x : corners) {
            high = std::max(high, glm::dot(x, axis) - slope * glm::dot(x, a.forward));
            low = std::max(low, -glm::dot(x, axis) - slope * glm::dot(x, a.forward));
        }
        return std::pair((high - low) / 2, -(high + low) / (2 * slope)); // along the axis, along forward
    };
    const auto [x, depth_x] = nearest_eye(a.right, slope_x);
    const auto [y, depth_y] = nearest_eye(a.up, slope_y);
    const double depth = std::min(depth_x, depth_y);
    double middle = 0;
    for (const glm::dvec3 &corner : corners)
        middle += glm::dot(corner, a.forward) / static_cast<double>(corners.size());
    Camera result = camera;
    result.eye = x * a.right + y * a.up + depth * a.forward;
    result.target = result.eye + std::max(middle - depth, 1e-9) * a.forward;
    return result;
}

Camera orbit(const Camera &camera, double yaw, double pitch, const glm::dvec3 &pivot) {
    const Axes a = axes(camera);
    const double polar = std::acos(std::clamp(glm::dot(a.forward, camera.up), -1.0, 1.0)); // of the line of sight
    const double least = glm::radians(1.0);
    pitch = std::clamp(polar - pitch, least, std::numbers::pi - least);
    pitch = polar - pitch;
    const glm::dmat4 turn =
        glm::rotate(glm::dmat4(1), yaw, camera.up) * glm::rotate(glm::dmat4(1), pitch, a.right);
    const auto about_pivot = [&](const glm::dvec3 &x) { return pivot + glm::dvec3(turn * glm::dvec4(x - pivot, 0)); };
    Camera result = camera;
    result.eye = about_pivot(camera.eye);
    result.target = about_pivot(camera.target);
    return result;
}

Camera pan(const Camera &camera, double dx, double dy, double height, const glm::dvec3 &anchor) {
    const Axes a = axes(camera);
    const double depth = std::max(glm::dot(anchor - camera.eye, a.forward), 0.0);
    const double pixel = 2 * std::tan(glm::radians(camera.fov_y) / 2) * depth / height;
    const glm::dvec3 move = pixel * (dy * a.up - dx * a.right);
    Camera result = camera;
    result.eye += move;
    result.target += move;
    return result;
}

Camera zoom(const Camera &camera, double factor, const glm::dvec3 &point) {
    Camera result = camera;
    result.eye = point + factor * (camera.eye - point);
    result.target = point + factor * (camera.target - point);
    return result;
}

Camera hold_width(const Camera &camera, double from_aspect, double to_aspect) {
    Camera result = camera;
    if (to_aspect < from_aspect)
        result.fov_y = 2 * glm::degrees(std::atan(std::tan(glm::radians(camera.fov_y) / 2) * from_aspect / to_aspect));
    return result;
}

glm::dmat4 view_matrix(const Camera &camera) { return glm::lookAt(camera.eye, camera.target, camera.up); }

glm::dmat4 projection_matrix(const Camera &camera, double aspect, const Bounds &box) {
    const Axes a = axes(camera);
    double nearest = std::numeric_limits<double>::max(), farthest = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 x(corner & 1 ? box.high.x : box.low.x, corner & 2 ? box.high.y : box.low.y,
                           corner & 4 ? box.high.z : box.low.z);
        const double depth = glm::dot(x - camera.eye, a.forward);
        nearest = std::min(nearest, depth);
        farthest = std::max(farthest, depth);
    }
    farthest = std::max({1.05 * farthest, glm::distance(camera.eye, camera.target), 1e-9});
    nearest = std::max(0.9 * nearest, 5e-4 * farthest); // 24 bits of depth hold about this ratio
    return glm::perspective(glm::radians(camera.fov_y), aspect, nearest, farthest);
}

glm::dvec3 view_ray(const Camera &camera, double aspect, double x, double y) {
    const Axes a = axes(camera);
    const double slope = std::tan(glm::radians(camera.fov_y) / 2);
    return glm::normalize(a.forward + x * aspect * slope * a.right + y * slope * a.up);
}

std::optional<glm::dvec2> place_in_frame(const Camera &camera, double aspect, const glm::dvec3 &point) {
    const Axes a = axes(camera);
    const glm::dvec3 way = point - camera.eye;
    const double depth = glm::dot(way, a.forward) * std::tan(glm::radians(camera.fov_y) / 2);
    if (!(depth > 0))
        return std::nullopt;
    return glm::dvec2(glm::dot(way, a.right) / (depth * aspect), glm::dot(way, a.up) / depth);
}

} // namespace penumbra
