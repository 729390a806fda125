#include "render/curve_crossing.h"

#include <algorithm>
#include <utility>

namespace penumbra {

std::vector<int> crossed_curves(const Snapshot &snapshot, int surface, const Vec3 &from, const Vec3 &to) {
    std::vector<std::pair<double, int>> crossed; // part of the way, curve
    if (!snapshot.curves)
        return {};
    const SnapshotSurface &s = snapshot.surfaces[static_cast<std::size_t>(surface)];
    const auto in_plane = [&](const Vec3 &p) { return Vec2((p - s.origin).dot(s.u), (p - s.origin).dot(s.v)); };
    const Vec2 start = in_plane(from), way = in_plane(to) - start;
    for (std::size_t i = 0; i < snapshot.curves->size(); ++i) {
        const SnapshotCurve &curve = (*snapshot.curves)[i];
        if (curve.receiver != surface)
            continue;
        for (std::size_t k = 0; k + 1 < curve.points.size(); ++k) {
            const Vec2 a = in_plane(curve.points[k]) - start, b = in_plane(curve.points[k + 1]) - start;
            const double before = cross(way, a), after = cross(way, b); // on either side of the way
            if ((before < 0) == (after < 0))
                continue;
            const Vec2 meeting = a + before / (before - after) * (b - a);
            const double part = meeting.dot(way) / way.squaredNorm();
            if (part >= 0 && part < 1)
                crossed.emplace_back(part, static_cast<int>(i));
        }
    }
    std::ranges::sort(crossed);
    std::vector<int> curves;
    for (const auto &[part, curve] : crossed)
        curves.push_back(curve);
    return curves;
}

} // namespace penumbra
