#include "discontinuity/edge_on.h"

#include "discontinuity/crossing.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace penumbra {

namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// A facet's edge that lies in the plane while the facet stays on one side of it, +1 or -1.
struct Graze {
    Vec3 p, q;
    int side;
};

/// Whether the grazed edge lies on the line pq.
bool on_line(const Graze &graze, const Vec3 &p, const Vec3 &q) {
    const Vec3 direction = (q - p).normalized();
    const auto off = [&](const Vec3 &x) { return direction.cross(x - p).norm(); };
    return off(graze.p) <= 2 * coincidence && off(graze.q) <= 2 * coincidence;
}

/// Distance along the ray, in units of the direction, at which it first meets the figure; infinite when it does not.
double hit(const Polygon &figure, const Vec2 &origin, const Vec2 &direction) {
    double nearest = never;
    for (std::size_t i = 0; i < figure.size(); ++i) {
        const Vec2 a = figure[i] - origin, b = figure[(i + 1) % figure.size()] - origin;
        const double side_a = cross(direction, a), side_b = cross(direction, b);
        if ((side_a < 0) == (side_b < 0))
            continue;
        const double t = (a + side_a / (side_a - side_b) * (b - a)).dot(direction) / direction.squaredNorm();
        if (t > 0)
            nearest = std::min(nearest, t);
    }
    return nearest;
}

bool sees(const EdgeOnScene &scene, std::span<const Vec2> points, const Vec2 &x) {
    return std::ranges::any_of(directions_between(points, x), [&](const Vec2 &direction) {
        const double mask = scene.masks.empty() ? 0 : first_hit(scene.masks, x, direction);
        if (mask == never)
            return false;
        const double target = first_hit(scene.targets, x, direction);
        return target < never && mask < target && first_hit(scene.blockers, x, direction) >= target;
    });
}

/// Pieces of the line between the points where the order of what is seen may change.
IntervalSet pieces_that_see(const EdgeOnScene &scene, IntervalSet line) {
    const std::vector<Vec2> points = points_of(scene);
    split_between(points, line);
    IntervalSet seeing;
    for (const Interval &piece : line.intervals())
        if (sees(scene, points, Vec2(piece.middle(), 0)))
            seeing.unite(piece);
    return seeing;
}

} // namespace

double first_hit(std::span<const Polygon> figures, const Vec2 &origin, const Vec2 &direction) {
    double nearest = never;
    for (const Polygon &figure : figures)
        nearest = std::min(nearest, hit(figure, origin, direction));
    return nearest;
}

std::vector<Vec2> points_of(const EdgeOnScene &scene) {
    std::vector<Vec2> points;
    for (const auto *figures : {&scene.targets, &scene.masks, &scene.blockers})
        for (const Polygon &figure : *figures)
            points.insert(points.end(), figure.begin(), figure.end());
    return points;
}

void split_between(std::span<const Vec2> points, IntervalSet &line) {
    if (line.empty())
        return;
    std::vector<double> places;
    const double low = line.intervals().front().low, high = line.intervals().back().high;
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t j = i + 1; j < points.size(); ++j)
            if (const double rise = points[j].y() - points[i].y(); std::abs(rise) > coincidence)
                if (const double at = points[i].x() - points[i].y() / rise * (points[j].x() - points[i].x());
                    at > low && at < high)
                    places.push_back(at);
    line.split(std::move(places));
}

std::vector<Vec2> directions_between(std::span<const Vec2> points, const Vec2 &x) {
    // All lie in the upper half-plane, where this grows with the angle: its half's tangent, or cotangent from 2 downwards.
    const auto turn = [](const Vec2 &d) { return d.x() >= 0 ? d.y() / (1 + d.x()) : 2 - d.y() / (1 - d.x()); };
    std::vector<Vec2> towards;
    for (const Vec2 &p : points)
        if (const Vec2 d = p - x; d.squaredNorm() > 0)
            towards.push_back(d.normalized());
    std::ranges::sort(towards, {}, turn);
    std::vector<Vec2> directions;
    for (std::size_t i = 0; i + 1 < towards.size(); ++i)
        if (cross(towards[i], towards[i + 1]) >= coincidence)
            directions.push_back((towards[i] + towards[i + 1]).normalized());
    return directions;
}

std::optional<Wedge> plane_of(const Facet &facet, const PlaneFrame &receiver) {
    // The widest corner in front of the receiver: its plane is the best conditioned.
    const std::size_t n = facet.corners.size();
    double widest = 0;
    std::size_t best = n;
    for (std::size_t i = 0; i < n; ++i) {
        const Vec3 &c = facet.corners[i];
        const double width = (facet.corners[(i + 1) % n] - c).cross(facet.corners[(i + n - 1) % n] - c).norm();
        if (receiver.height(c) > coincidence && width > widest) {
            widest = width;
            best = i;
        }
    }
    if (best == n)
        return std::nullopt;
    auto plane =
        make_wedge(facet.corners[best], facet.corners[(best + 1) % n], facet.corners[(best + n - 1) % n], receiver);
    if (plane)
        plane->slack = coincidence + 2 * facet.bend;
    return plane;
}

Polygon flattened(const Wedge &plane, const std::vector<Vec3> &corners) {
    const Vec3 up =
        plane.normal.cross(plane.along) * (plane.normal.cross(plane.along).dot(plane.receiver.normal) > 0 ? 1.0 : -1.0);
    Polygon flat;
    for (const Vec3 &c : corners)
        flat.emplace_back((c - plane.foot).dot(plane.along), std::max(0.0, (c - plane.foot).dot(up)));
    return flat;
}

EdgeOnScene edge_on_scene(const SourceView &view, std::span<const std::size_t> facets, const Wedge &plane, int front) {
    EdgeOnScene scene;
    for (const Facet &part : view.source_parts)
        if (const Crossing c = cross_facet(plane, part); c.through() || c.along_edge())
            scene.targets.push_back(flattened(plane, {c.p, c.q}));
    std::vector<Graze> bordering;
    for (const std::size_t f : facets) {
        const Facet &facet = view.facets[f];
        if (std::abs(plane.height(facet.centre)) > facet.radius + coincidence)
            continue;
        const Crossing c = cross_facet(plane, facet);
        if (c.through() || (c.along_edge() && (c.left ? 1 : -1) == front))
            scene.blockers.push_back(flattened(plane, {c.p, c.q}));
        else if (c.along_edge())
            bordering.push_back({c.p, c.q, c.left ? 1 : -1});
    }
    for (const Graze &one : bordering)
        for (const Graze &other : bordering) {
            if (one.side <= other.side || !on_line(one, other.p, other.q))
                continue;
            const Vec3 direction = (one.q - one.p).normalized();
            const Interval common =
                overlap(between(0, (one.q - one.p).dot(direction)),
                        between((other.p - one.p).dot(direction), (other.q - one.p).dot(direction)));
            if (!common.empty())
                scene.blockers.push_back(
                    flattened(plane, {one.p + common.low * direction, one.p + common.high * direction}));
        }
    return scene;
}

IntervalSet edge_on_sight(const EdgeOnScene &scene, IntervalSet line) {
    if (scene.targets.empty())
        return {};
    // Most lines see no mask before a target at all: only the others pay for the blockers' many points.
    line = pieces_that_see({scene.targets, scene.masks, {}}, std::move(line));
    return scene.blockers.empty() || line.empty() ? line : pieces_that_see(scene, std::move(line));
}

} // namespace penumbra
