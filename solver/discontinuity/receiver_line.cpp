#include "discontinuity/receiver_line.h"

#include <cmath>

namespace penumbra {

namespace {

/// The parts of the line that run along the polygon's border.
void subtract_border(IntervalSet &line, const Polygon &polygon, const Vec2 &foot, const Vec2 &along) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        if (std::abs(cross(along, a - foot)) <= 2 * coincidence && std::abs(cross(along, b - foot)) <= 2 * coincidence)
            line.subtract(between((a - foot).dot(along), (b - foot).dot(along)));
    }
}

} // namespace

Interval inside(const Polygon &convex, const Vec2 &foot, const Vec2 &along) {
    Interval part;
    for (std::size_t i = 0; i < convex.size(); ++i) {
        const Vec2 &a = convex[i];
        const Vec2 edge = convex[(i + 1) % convex.size()] - a;
        const double here = cross(edge, foot - a), rate = cross(edge, along), rounding = coincidence * edge.norm();
        if (std::abs(rate) < rounding) {
            if (here < -rounding)
                return {0, 0};
        } else if (rate > 0) {
            part.low = std::max(part.low, -here / rate);
        } else {
            part.high = std::min(part.high, -here / rate);
        }
    }
    return part;
}

IntervalSet lit_part(const Scene &scene, const SourceView &view, const Vec3 &foot, const Vec3 &along) {
    const Surface &receiver = scene.surface(view.receiver);
    const Vec2 foot2 = receiver.frame.to_plane(foot), along2(along.dot(receiver.frame.u), along.dot(receiver.frame.v));
    IntervalSet line;
    for (const Polygon &part : receiver.parts)
        line.unite(inside(part, foot2, along2), coincidence);
    subtract_border(line, receiver.outline, foot2, along2);
    for (const Polygon &cover : receiver.covers) {
        IntervalSet covered(inside(cover, foot2, along2));
        subtract_border(covered, cover, foot2, along2);
        for (const Interval &i : covered.intervals())
            line.subtract(i);
    }
    const double height = view.source_plane.height(foot), rate = along.dot(view.source_plane.normal);
    if (std::abs(rate) >= coincidence)
        line.clip(rate > 0 ? Interval{-height / rate, Interval{}.high} : Interval{Interval{}.low, -height / rate});
    else if (height < -coincidence)
        return {};
    return line;
}

} // namespace penumbra
