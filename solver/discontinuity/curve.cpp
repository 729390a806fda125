#include "discontinuity/curve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace penumbra {

std::string_view name(CurveKind kind) {
    constexpr std::array<std::string_view, 5> names{"VE", "EV", "EEE", "plane", "contact"};
    return names[static_cast<std::size_t>(kind)];
}

namespace {

double distance_to_segment(const Vec2 &a, const Vec2 &b, const Vec2 &p) {
    const Vec2 d = b - a;
    const double length2 = d.squaredNorm(), t = length2 > 0 ? std::clamp((p - a).dot(d) / length2, 0.0, 1.0) : 0;
    return (a + t * d - p).norm();
}

/// Adds the points after the one at t0, up to and with the one at t1.
void add_points(const Curve &curve, double t0, double t1, double tolerance, int depth, std::vector<Vec2> &points) {
    const double middle = (t0 + t1) / 2;
    const Vec2 a = point_at(curve, t0), b = point_at(curve, t1);
    // A conic has no inflection: between a and b it is farthest from the chord on one side only, near the middle.
    const double off = std::max({distance_to_segment(a, b, point_at(curve, middle)),
                                 distance_to_segment(a, b, point_at(curve, (t0 + middle) / 2)),
                                 distance_to_segment(a, b, point_at(curve, (middle + t1) / 2))});
    if (depth == 0 || off <= tolerance / 2) {
        points.push_back(b);
        return;
    }
    add_points(curve, t0, middle, tolerance, depth - 1, points);
    add_points(curve, middle, t1, tolerance, depth - 1, points);
}

} // namespace

Vec2 point_at(const Curve &curve, double t) {
    const double a = (1 - t) * (1 - t), b = 2 * t * (1 - t), c = t * t;
    return (a * curve.from + b * curve.control.head<2>() + c * curve.to) / (a + b * curve.control.z() + c);
}

std::vector<Vec2> polyline(const Curve &curve, double tolerance) {
    std::vector<Vec2> points{curve.from};
    if (curve.straight())
        points.push_back(curve.to);
    else
        add_points(curve, 0, 1, tolerance, 16, points);
    return points;
}

double distance(const Curve &curve, const Vec2 &p) {
    if (curve.straight())
        return distance_to_segment(curve.from, curve.to, p);
    double nearest = std::numeric_limits<double>::infinity();
    // Coarse first: most curves are far from most points.
    for (double tolerance = 1e-3;; tolerance /= 10) {
        nearest = std::numeric_limits<double>::infinity();
        const std::vector<Vec2> points = polyline(curve, tolerance);
        for (std::size_t i = 0; i + 1 < points.size(); ++i)
            nearest = std::min(nearest, distance_to_segment(points[i], points[i + 1], p));
        if (tolerance <= std::max(1e-9, 1e-3 * nearest))
            return nearest;
    }
}

} // namespace penumbra
