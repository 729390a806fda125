#include "transport/lit_points.h"

#include <algorithm>
#include <cmath>

namespace penumbra {

std::vector<Vec2> lit_points(const Element &p, const Surface &to, const Surface &from) {
    std::vector<Vec2> points;
    // A point at height h in an upright source lights a floor most at the distance d = h / sqrt(3) in front of it, where
    // h d / (h^2 + d^2)^2 is largest.
    const Vec2 ahead(from.frame.normal.dot(to.frame.u), from.frame.normal.dot(to.frame.v));
    const auto add = [&](const Vec2 &y) {
        const Vec3 at = from.frame.to_space(y);
        const double away = std::max(0.05 * radius(from.outline), to.frame.height(at) / std::sqrt(3.0));
        points.push_back(nearest_point(p.basis.outline(), to.frame.to_plane(at) + away * ahead));
    };
    for (std::size_t i = 0; i < from.outline.size(); ++i) {
        add(from.outline[i]);
        add((from.outline[i] + from.outline[(i + 1) % from.outline.size()]) / 2);
    }
    for (const Polygon &part : from.parts)
        add(centroid(part));
    return points;
}

bool lights_a_spot(const Element &p, const Surface &from, double distance) {
    return distance + radius(from.outline) < 0.5 * radius(p.basis.outline());
}

} // namespace penumbra
