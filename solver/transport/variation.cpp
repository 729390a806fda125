#include "transport/variation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace penumbra {

namespace {

/// The gap between the two along the line of their centres: not more than their distance.
double least_distance(const Element &p, const Surface &to, const Surface &from) {
    const Vec3 centre = to.frame.to_space(p.basis.centre());
    Vec3 other = Vec3::Zero();
    for (const Vec3 &corner : from.corners)
        other += corner / static_cast<double>(from.corners.size());
    const Vec3 towards = (other - centre).normalized();
    double far_end = -std::numeric_limits<double>::infinity(), near_end = -far_end;
    for (const Vec2 &corner : p.basis.outline())
        far_end = std::max(far_end, towards.dot(to.frame.to_space(corner) - centre));
    for (const Vec3 &corner : from.corners)
        near_end = std::min(near_end, towards.dot(corner - centre));
    return near_end - far_end;
}

double spread(const ElementBasis &basis) {
    const Vec2 centre = centroid(basis.outline());
    double most = 0;
    for (const Vec2 &corner : basis.outline())
        most = std::max(most, (corner - centre).norm());
    return most;
}

} // namespace

double variation_bound(const Forest &forest, const Element &p, const Surface &to, const Surface &from,
                       std::span<const ElementId> nodes, double form_factor) {
    const double distance = least_distance(p, to, from);
    if (!(distance > 0))
        return std::numeric_limits<double>::infinity();
    double moved = 0;
    for (const ElementId q : nodes)
        moved = std::max(moved, spread(forest[q].basis));
    moved += std::numbers::sqrt2 * spread(p.basis);
    const double sine = to.frame.normal.cross(from.frame.normal).norm();
    return moved * (sine * from.area / (std::numbers::pi * std::pow(distance, 3)) + 4 * form_factor / distance);
}

} // namespace penumbra
