#include "measure/cone_blockers.h"

#include <algorithm>

namespace penumbra {

bool behind(const PlaneFrame &plane, std::span<const Vec3> polygon) {
    return std::ranges::all_of(polygon, [&](const Vec3 &c) { return plane.height(c) <= 1e-12; });
}

void blockers_in_cone(const Vec3 &x, const PlaneFrame &receiver, const PlaneFrame &source, std::span<const Vec2> polygon,
                      const Blockers &blockers, const std::vector<PairBlocker> *among, std::vector<PairBlocker> &found) {
    thread_local std::vector<Vec3> outward; // normals of the cone's side planes
    outward.clear();
    Vec3 low = x, high = x;
    for (const Vec2 &p : polygon) {
        low = low.cwiseMin(source.to_space(p));
        high = high.cwiseMax(source.to_space(p));
    }
    for (std::size_t i = 0; i < polygon.size(); ++i)
        outward.push_back((source.to_space(polygon[i]) - x)
                              .cross(source.to_space(polygon[(i + 1) % polygon.size()]) - x));
    const auto consider = [&](const PairBlocker &b) {
        const std::vector<Vec3> &corners = blockers[b.blocker].corners;
        const bool outside = std::ranges::any_of(outward, [&](const Vec3 &n) {
            return std::ranges::all_of(corners, [&](const Vec3 &c) { return n.dot(c - x) >= 0; });
        });
        if (!outside && !behind(receiver, corners) && !behind(source, corners))
            found.push_back(b);
    };
    found.clear();
    if (among)
        for (const PairBlocker &b : *among)
            consider(b);
    else
        for (const int b : blockers.near_box(low, high))
            consider({b, false});
}

} // namespace penumbra
