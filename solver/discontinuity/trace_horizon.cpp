#include "discontinuity/trace_horizon.h"

#include "discontinuity/receiver_line.h"

#include <algorithm>
#include <cmath>

namespace penumbra {

namespace {

/// What a facet has in common with the receiver's plane; a point when both ends coincide.
struct Foot {
    Vec2 p, q;
    SurfaceId surface;
};

std::vector<Foot> feet_of(const SourceView &view) {
    std::vector<Foot> feet;
    for (const Facet &facet : view.facets) {
        std::vector<Vec2> low;
        for (const Vec3 &c : facet.corners)
            if (std::abs(view.receiver_plane.height(c)) <= coincidence)
                low.push_back(view.receiver_plane.to_plane(c));
        if (!low.empty())
            feet.push_back({low.front(), low.back(), facet.surface});
    }
    return feet;
}

void add_point(std::vector<Vec2> &points, const Vec2 &p) {
    if (std::ranges::none_of(points, [&](const Vec2 &known) { return (known - p).norm() <= 2 * coincidence; }))
        points.push_back(p);
}

std::vector<Vec2> horizon_corners(const SourceView &view) {
    std::vector<Vec2> corners;
    for (const SightEdge &edge : view.edges)
        for (const Vec3 &end : {edge.from(), edge.to()})
            if (edge.of_source && std::abs(view.receiver_plane.height(end)) <= coincidence)
                add_point(corners, view.receiver_plane.to_plane(end));
    return corners;
}

/// A ray of the plane, and the distance from which on feet hide its origin.
struct Ray {
    Vec2 origin, along;
    double hidden_from = Interval{}.high;

    double off(const Vec2 &p) const {
        const double d = cross(along, p - origin);
        return std::abs(d) <= 2 * coincidence ? 0 : d;
    }
    double at(const Vec2 &p) const { return (p - origin).dot(along); }
    void hide(double distance) {
        if (distance > coincidence)
            hidden_from = std::min(hidden_from, distance);
    }
};

void hide_behind_feet(Ray &ray, const std::vector<Foot> &feet) {
    struct Graze {
        double distance;
        bool left;
    };
    std::vector<Graze> grazes;
    for (const Foot &foot : feet) {
        const double p = ray.off(foot.p), q = ray.off(foot.q);
        if (p * q < 0)
            ray.hide(ray.at(foot.p + p / (p - q) * (foot.q - foot.p)));
        else if (p == 0 && q != 0)
            grazes.push_back({ray.at(foot.p), q > 0});
        else if (q == 0 && p != 0)
            grazes.push_back({ray.at(foot.q), p > 0});
    }
    for (const Graze &one : grazes)
        for (const Graze &other : grazes)
            if (one.left && !other.left && std::abs(one.distance - other.distance) <= 4 * coincidence)
                ray.hide(one.distance);
}

} // namespace

void trace_horizon(const Scene &scene, const SourceView &view, std::vector<Curve> &curves) {
    const std::vector<Vec2> corners = horizon_corners(view);
    if (corners.empty())
        return;
    const std::vector<Foot> feet = feet_of(view);
    std::vector<Vec2> ends;
    for (const Foot &foot : feet) {
        add_point(ends, foot.p);
        add_point(ends, foot.q);
    }
    for (const Vec2 &corner : corners)
        for (const Vec2 &end : ends) {
            const double distance = (end - corner).norm();
            if (distance <= 4 * coincidence)
                continue;
            Ray ray{corner, (end - corner) / distance};
            hide_behind_feet(ray, feet);
            if (ray.hidden_from < distance + 4 * coincidence)
                continue;
            const PlaneFrame &plane = view.receiver_plane;
            IntervalSet line =
                lit_part(scene, view, plane.to_space(corner), ray.along.x() * plane.u + ray.along.y() * plane.v);
            line.clip(Interval{distance, ray.hidden_from});
            line.drop_shorter(shortest_curve);
            std::vector<SurfaceId> blockers;
            for (const Foot &foot : feet)
                if ((foot.p - end).norm() <= 2 * coincidence || (foot.q - end).norm() <= 2 * coincidence)
                    blockers.push_back(foot.surface);
            std::ranges::sort(blockers);
            for (const Interval &i : line.intervals())
                curves.push_back({CurveKind::ve, 2, view.source, view.receiver, blockers, corner + i.low * ray.along,
                                  corner + i.high * ray.along});
        }
}

} // namespace penumbra
