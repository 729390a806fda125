#include "geometry/polygon.h"

#include <algorithm>
#include <limits>
#include <ranges>

namespace penumbra {

double area(std::span<const Vec2> polygon) {
    double sum = 0;
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
        sum += cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
    return sum / 2;
}

Vec2 centroid(std::span<const Vec2> polygon) {
    Vec2 moment = Vec2::Zero();
    double sum = 0;
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
        const Vec2 a = polygon[i] - polygon[0], b = polygon[i + 1] - polygon[0];
        const double twice = cross(a, b);
        moment += twice * (a + b) / 3;
        sum += twice;
    }
    return sum == 0 ? polygon[0] : Vec2(polygon[0] + moment / sum);
}

double radius(std::span<const Vec2> polygon) {
    Vec2 low = polygon[0], high = polygon[0];
    for (const Vec2 &p : polygon) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    return (high - low).norm() / 2;
}

bool contains(std::span<const Vec2> convex, const Vec2 &p, double slack) {
    for (std::size_t i = 0; i < convex.size(); ++i) {
        const Vec2 &a = convex[i];
        const Vec2 edge = convex[(i + 1) % convex.size()] - a;
        if (cross(edge, p - a) < -slack * edge.norm())
            return false;
    }
    return true;
}

Vec2 nearest_point(std::span<const Vec2> convex, const Vec2 &p) {
    // Of a polygon without area the sides' whole line is on the inner side of all of them: its box has the ends.
    Vec2 low = convex[0], high = convex[0];
    for (const Vec2 &corner : convex) {
        low = low.cwiseMin(corner);
        high = high.cwiseMax(corner);
    }
    if ((p.array() >= low.array()).all() && (p.array() <= high.array()).all() && contains(convex, p))
        return p;
    Vec2 best = convex[0];
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < convex.size(); ++i) {
        const Vec2 &a = convex[i];
        const Vec2 edge = convex[(i + 1) % convex.size()] - a;
        const double length2 = edge.squaredNorm();
        const double t = length2 > 0 ? std::clamp((p - a).dot(edge) / length2, 0.0, 1.0) : 0.0;
        const Vec2 q = a + t * edge;
        if (const double d = (p - q).squaredNorm(); d < least) {
            least = d;
            best = q;
        }
    }
    return best;
}

Polygon convex_hull(Polygon points) {
    std::ranges::sort(points, [](const Vec2 &a, const Vec2 &b) {
        return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
    });
    Polygon hull;
    const auto chain = [&](const auto &range) {
        const std::size_t start = hull.size();
        for (const Vec2 &p : range) {
            while (hull.size() >= start + 2 && cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0)
                hull.pop_back();
            hull.push_back(p);
        }
        hull.pop_back();
    };
    if (points.size() < 3)
        return points;
    chain(points);
    chain(points | std::views::reverse);
    return hull;
}

std::vector<Polygon> quads_and_triangles(const Polygon &convex) {
    std::vector<Polygon> pieces;
    Polygon rest = convex;
    while (rest.size() > 4) {
        pieces.push_back({rest[0], rest[1], rest[2], rest[3]});
        rest.erase(rest.begin() + 1, rest.begin() + 3);
    }
    pieces.push_back(std::move(rest));
    return pieces;
}

} // namespace penumbra
