#include "iteration/probe.h"

#include "geometry/polygon.h"

#include <cmath>
#include <limits>

namespace penumbra {

std::optional<Rgb> radiosity_at(const Snapshot &snapshot, const Vec3 &x, const Vec3 &normal, double reach) {
    struct {
        const SnapshotPatch *patch = nullptr;
        Vec2 point = Vec2::Zero();
        bool covered = true;
        double distance = std::numeric_limits<double>::infinity();
    } best;
    for (const SnapshotPatch &patch : snapshot.patches) {
        const SnapshotSurface &surface = snapshot.surfaces[static_cast<std::size_t>(patch.surface)];
        const Vec3 from_origin = x - surface.origin;
        const double height = from_origin.dot(surface.normal);
        if (!(surface.normal.dot(normal) > 0.9) || !(std::abs(height) <= reach))
            continue;
        const Vec2 foot = to_plane(surface, x);
        const Vec2 nearest = nearest_point(patch.corners, foot);
        const double distance = std::hypot((nearest - foot).norm(), height);
        if (distance > reach)
            continue;
        const bool covered = is_covered(surface, nearest);
        if (covered < best.covered || (covered == best.covered && distance < best.distance))
            best = {&patch, nearest, covered, distance};
    }
    return best.patch ? std::optional(radiosity(snapshot, *best.patch, best.point)) : std::nullopt;
}

} // namespace penumbra
