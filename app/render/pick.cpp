#include "render/pick.h"

#include "geometry/polygon.h"
#include "render/surface_role.h"

#include <limits>

namespace penumbra {

int patch_at(const Snapshot &snapshot, int surface, const Vec2 &p) {
    int best = -1;
    double nearest = std::numeric_limits<double>::max();
    double slack = 0; // a point on a side that rounding has put into neither patch belongs to the nearer one
    for (const Vec2 &c : snapshot.surfaces[static_cast<std::size_t>(surface)].outline)
        slack = std::max(slack, 1e-9 * (c - p).norm());
    for (std::size_t i = 0; i < snapshot.patches.size(); ++i) {
        const SnapshotPatch &patch = snapshot.patches[i];
        if (patch.surface != surface)
            continue;
        double outside = 0;
        for (std::size_t k = 0; k < patch.corners.size(); ++k) {
            const Vec2 &a = patch.corners[k], side = patch.corners[(k + 1) % patch.corners.size()] - a;
            if (side.norm() > 0)
                outside = std::max(outside, -cross(side, p - a) / side.norm());
        }
        if (outside <= slack && outside < nearest) {
            nearest = outside;
            best = static_cast<int>(i);
        }
    }
    return best;
}

std::optional<Pick> pick(const Snapshot &snapshot, const Camera &camera, double aspect, double x, double y) {
    const glm::dvec3 way = view_ray(camera, aspect, x, y);
    const Vec3 eye(camera.eye.x, camera.eye.y, camera.eye.z), ray(way.x, way.y, way.z);
    std::optional<Pick> best;
    double nearest = std::numeric_limits<double>::max();
    int best_rank = 0;
    for (std::size_t i = 0; i < snapshot.surfaces.size(); ++i) {
        const SnapshotSurface &s = snapshot.surfaces[i];
        const double toward = ray.dot(s.normal);
        if (toward >= 0 || role(s) == SurfaceRole::blocker)
            continue;
        const double t = (s.origin - eye).dot(s.normal) / toward;
        // In one plane the surface that others lie on is the lower one.
        const bool same_plane = best && std::abs(t - nearest) <= 1e-9 * nearest;
        if (t <= 0 || (same_plane ? rank(s) >= best_rank : t > nearest))
            continue;
        const Vec3 point = eye + t * ray;
        const Vec2 p = to_plane(s, point);
        if (!holds(s, p))
            continue;
        nearest = t;
        best_rank = rank(s);
        const int patch = patch_at(snapshot, static_cast<int>(i), p);
        best = Pick{static_cast<int>(i), patch, point,
                    patch < 0 ? Rgb(Rgb::Zero())
                              : radiosity(snapshot, snapshot.patches[static_cast<std::size_t>(patch)], p)};
    }
    return best;
}

} // namespace penumbra
