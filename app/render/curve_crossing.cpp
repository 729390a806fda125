#include "render/curve_crossing.h"

#include <algorithm>

namespace penumbra {

std::vector<CurveCrossing> crossed_curves(const Snapshot &snapshot, int surface, const Vec3 &from, const Vec3 &to) {
    std::vector<CurveCrossing> crossed;
    if (!snapshot.curves)
        return {};
    const SnapshotSurface &s = snapshot.surfaces[static_cast<std::size_t>(surface)];
    const Vec2 start = to_plane(s, from), way = to_plane(s, to) - start;
    for (std::size_t i = 0; i < snapshot.curves->size(); ++i) {
        const SnapshotCurve &curve = (*snapshot.curves)[i];
        if (curve.receiver != surface)
            continue;
        for (std::size_t k = 0; k + 1 < curve.points.size(); ++k) {
            const Vec2 a = to_plane(s, curve.points[k]) - start, b = to_plane(s, curve.points[k + 1]) - start;
            const double before = cross(way, a), after = cross(way, b); // on either side of the way
            if ((before < 0) == (after < 0))
                continue;
            const Vec2 meeting = a + before / (before - after) * (b - a);
            const double part = meeting.dot(way) / way.squaredNorm();
            if (part >= 0 && part < 1)
                crossed.push_back({part, static_cast<int>(i)});
        }
    }
    std::ranges::sort(crossed);
    return crossed;
}

} // namespace penumbra
