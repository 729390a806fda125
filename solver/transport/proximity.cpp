#include "transport/proximity.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace penumbra {

namespace {

double distance_from(const Vec3 &x, const PlaneFrame &frame, const Polygon &convex) {
    const Vec2 foot = frame.to_plane(x);
    return std::hypot(frame.height(x), (foot - nearest_point(convex, foot)).norm());
}

} // namespace

double corner_distance(const Element &p, const Surface &to, const Surface &from) {
    double least = std::numeric_limits<double>::infinity();
    for (const Polygon &part : from.parts) {
        for (const Vec2 &corner : p.basis.outline())
            least = std::min(least, distance_from(to.frame.to_space(corner), from.frame, part));
        for (const Vec2 &corner : part)
            least = std::min(least, distance_from(from.frame.to_space(corner), to.frame, p.basis.outline()));
    }
    return least;
}

std::vector<Vec2> touching_corners(const Element &p, const Surface &to, const Surface &from) {
    std::vector<Vec2> found;
    for (const Vec3 &corner : from.corners)
        if (distance_from(corner, to.frame, p.basis.outline()) < 1e-9)
            found.push_back(to.frame.to_plane(corner));
    return found;
}

} // namespace penumbra
