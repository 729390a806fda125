#include "transport/lambert.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace penumbra {

namespace {

/// An edge as x sees it, in the source's plane: from `a` by `along`, relative to x's foot.
struct Edge {
    Vec2 along;
    double area;  ///< twice that of the triangle with the foot, positive when the foot is on the inside
    double dot;   ///< of the vectors from the foot to the ends
    double sine2; ///< squared sine of the angle, times both distances

    Edge(const Vec2 &a, const Vec2 &b, double height)
        : along(b - a), area(cross(a, along)), dot(a.dot(b)),
          sine2(area * area + height * height * along.squaredNorm()) {}
};

/// angle * area / sine - (the same at height 0), which is O(height^2) and is computed as such.
double change_from_height_0(const Edge &e, double height) {
    const double h2 = height * height, c = std::abs(e.area), sine = std::sqrt(e.sine2);
    const double angle = std::atan2(sine, e.dot + h2);
    const double rise = h2 * e.along.squaredNorm() / (sine + c); // sine - c
    const double turn = std::atan2(rise * e.dot - c * h2, (e.dot + h2) * e.dot + sine * c);
    const double change = turn - angle * rise / sine;
    return e.area < 0 ? -change : change;
}

} // namespace

double lambert(const Vec3 &x, const Vec3 &n, const PlaneFrame &source, std::span<const Vec2> polygon) {
    const Vec2 foot = source.to_plane(x);
    const double height = source.height(x), facing = -n.dot(source.normal);
    const Vec2 n_plane(n.dot(source.u), n.dot(source.v));
    const auto for_each_edge = [&](const auto &visit) {
        Vec2 from = polygon.back() - foot;
        for (const Vec2 &p : polygon) {
            const Vec2 to = p - foot;
            if (const Edge edge(from, to, height); edge.sine2 > 0)
                visit(edge);
            from = to;
        }
    };
    double across = 0, sideways = 0;
    bool grazing = false; // the foot lies outside, by ten times the height or more
    for_each_edge([&](const Edge &e) {
        const double sine = std::sqrt(e.sine2), share = std::atan2(sine, e.dot + height * height) / sine;
        across += share * e.area;
        sideways += share * cross(e.along, n_plane);
        grazing |= e.area < 0 && 1.01 * e.area * e.area > e.sine2;
    });
    // Then the edges' angles in the plane sum to 0, and what is left must not be left to rounding.
    if (grazing) {
        across = 0;
        for_each_edge([&](const Edge &e) { across += change_from_height_0(e, height); });
    }
    return std::max(0.0, (facing * across + height * sideways) / (2 * std::numbers::pi));
}

} // namespace penumbra
