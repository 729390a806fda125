#include "render/surface_role.h"

#include <algorithm>

namespace penumbra {
namespace {

Vec3 middle(const SnapshotSurface &s) {
    Vec3 sum = Vec3::Zero();
    for (const Vec2 &p : s.outline)
        sum += to_space(s, p);
    return sum / static_cast<double>(std::max<std::size_t>(1, s.outline.size()));
}

} // namespace

SurfaceRole role(const SnapshotSurface &surface) {
    if (surface.exitance.maxCoeff() > 0)
        return SurfaceRole::emitter;
    return surface.reflectance.maxCoeff() > 0 ? SurfaceRole::reflector : SurfaceRole::blocker;
}

std::vector<Back> backs(const Snapshot &snapshot) {
    const auto &surfaces = snapshot.surfaces;
    std::vector<Vec3> corners, middles;
    for (const SnapshotSurface &s : surfaces) {
        for (const Vec2 &p : s.outline)
            corners.push_back(to_space(s, p));
        middles.push_back(middle(s));
    }
    double extent = 0;
    for (const Vec3 &x : corners)
        extent = std::max(extent, (x - corners.front()).norm());
    const double slack = 1e-6 * extent;

    std::vector<Back> result(surfaces.size(), Back::glass);
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        const SnapshotSurface &s = surfaces[i];
        const bool outermost = std::all_of(corners.begin(), corners.end(),
                                           [&](const Vec3 &x) { return (x - s.origin).dot(s.normal) >= -slack; });
        bool two_sided = false;
        for (std::size_t j = 0; j < surfaces.size() && !two_sided; ++j)
            two_sided = s.normal.dot(surfaces[j].normal) < -1 + 1e-9 && (middles[i] - middles[j]).norm() <= slack;
        if (two_sided || (outermost && role(s) == SurfaceRole::reflector))
            result[i] = Back::hidden;
    }
    return result;
}

} // namespace penumbra
