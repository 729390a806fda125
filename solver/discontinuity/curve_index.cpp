#include "discontinuity/curve_index.h"

#include "discontinuity/merge_curves.h"
#include "discontinuity/receiver_line.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace penumbra {

namespace {

constexpr double most_sagitta = 0.125; // of the polygon's radius: an arc farther from its chord is halved
constexpr int most_halvings = 4;       // of one arc

/// Whether the segment lies on, or outside of, one side: the common case, and the border's.
bool outside_or_border(const Polygon &convex, const Vec2 &from, const Vec2 &to) {
    for (std::size_t i = 0; i < convex.size(); ++i) {
        const Vec2 edge = convex[(i + 1) % convex.size()] - convex[i];
        const double slack = 2 * coincidence * edge.norm();
        if (cross(edge, from - convex[i]) <= slack && cross(edge, to - convex[i]) <= slack)
            return true;
    }
    return false;
}

/// The straight curve's part inside; empty also when it runs along the border.
Interval part_inside(const Curve &curve, const Vec2 &along, double length, const Polygon &convex) {
    if (outside_or_border(convex, curve.from, curve.to))
        return {0, 0};
    return overlap(inside(convex, curve.from, along), {0, length});
}

/// The roots in (0, 1) of a (1-t)^2 + 2 b t (1-t) + c t^2.
void add_roots(double a, double b, double c, std::vector<double> &roots) {
    const double second = a - 2 * b + c, half = b - a, under = half * half - second * a;
    if (under < 0)
        return;
    // The root without cancellation, and the other from the product of the two.
    const double q = -(half + std::copysign(std::sqrt(under), half));
    for (const double t : {second != 0 ? q / second : -1, q != 0 ? a / q : -1})
        if (t > 0 && t < 1)
            roots.push_back(t);
}

/// Parameters of the arc's parts inside.
std::vector<Interval> parts_inside(const Curve &arc, const Polygon &convex) {
    std::vector<double> ends{0, 1};
    for (std::size_t i = 0; i < convex.size(); ++i) {
        const Vec2 &a = convex[i], edge = convex[(i + 1) % convex.size()] - a;
        add_roots(cross(edge, arc.from - a), cross(edge, arc.control.head<2>() - arc.control.z() * a),
                  cross(edge, arc.to - a), ends);
    }
    std::ranges::sort(ends);
    std::vector<Interval> parts;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        const Interval part{ends[i], ends[i + 1]};
        if (part.empty() || !contains(convex, point_at(arc, part.middle())))
            continue;
        if (!parts.empty() && parts.back().high == part.low)
            parts.back().high = part.high;
        else
            parts.push_back(part);
    }
    return parts;
}

double weight_at(const Curve &arc, double t) {
    return (1 - t) * (1 - t) + 2 * t * (1 - t) * arc.control.z() + t * t;
}

/// The parameter of the shoulder: where the tangent is parallel to the chord, the point farthest from it.
double shoulder(const Curve &arc, const Interval &part) {
    return part.low + part.length() / (1 + std::sqrt(weight_at(arc, part.high) / weight_at(arc, part.low)));
}

void add_chords(const Curve &arc, CurveId id, const Interval &part, const Polygon &convex, double most, int halvings,
                std::vector<CurveSegment> &chords) {
    const Vec2 from = point_at(arc, part.low), to = point_at(arc, part.high), chord = to - from;
    if (chord.norm() < shortest_curve)
        return;
    const double middle = shoulder(arc, part);
    const double sagitta = std::abs(cross(chord.normalized(), point_at(arc, middle) - from));
    const bool border = outside_or_border(convex, from, to);
    if (halvings > 0 && sagitta > (border ? 2 * coincidence : most)) {
        add_chords(arc, id, {part.low, middle}, convex, most, halvings - 1, chords);
        add_chords(arc, id, {middle, part.high}, convex, most, halvings - 1, chords);
    } else if (!border) {
        chords.push_back({id, arc.order, from, to});
    }
}

Eigen::AlignedBox2d box_of(const Curve &curve) {
    Eigen::AlignedBox2d box(curve.from);
    box.extend(curve.to);
    // With a positive weight the arc lies in the triangle of its control points; else anywhere.
    if (curve.control.z() > 0)
        box.extend(Vec2(curve.control.head<2>() / curve.control.z()));
    else if (!curve.straight())
        box = Eigen::AlignedBox2d(Vec2::Constant(-std::numeric_limits<double>::infinity()),
                                  Vec2::Constant(std::numeric_limits<double>::infinity()));
    return box;
}

} // namespace

CurveIndex::CurveIndex(std::vector<Curve> curves, int n_surfaces)
    : curves_(std::move(curves)), by_receiver_(static_cast<std::size_t>(n_surfaces)) {
    for (std::size_t c = 0; c < curves_.size(); ++c) {
        by_receiver_[curves_[c].receiver.at()].emplace_back(c);
        boxes_.push_back(box_of(curves_[c]));
    }
}

std::vector<CurveSegment> CurveIndex::crossing(SurfaceId receiver, const Polygon &convex,
                                               std::span<const SurfaceId> sources) const {
    std::vector<CurveSegment> segments;
    Eigen::AlignedBox2d box;
    for (const Vec2 &corner : convex)
        box.extend(corner);
    for (const CurveId id : on_receiver(receiver)) {
        const Curve &c = curve(id);
        if (!boxes_[id.at()].intersects(box) || std::ranges::find(sources, c.source) == sources.end())
            continue;
        if (!c.straight()) {
            for (const Interval &part : parts_inside(c, convex))
                add_chords(c, id, part, convex, most_sagitta * radius(convex), most_halvings, segments);
            continue;
        }
        const double length = (c.to - c.from).norm();
        const Vec2 along = (c.to - c.from) / length;
        const Interval part = part_inside(c, along, length, convex);
        if (part.length() < shortest_curve)
            continue;
        const auto twin = std::ranges::find_if(segments, [&](const CurveSegment &s) {
            const Curve &other = curve(s.curve);
            return other.straight() && other.source != c.source && in_line(other, c);
        });
        if (twin == segments.end()) {
            segments.push_back({id, c.order, c.from + part.low * along, c.from + part.high * along});
            continue;
        }
        const Interval known = between((twin->from - c.from).dot(along), (twin->to - c.from).dot(along));
        twin->from = c.from + std::min(known.low, part.low) * along;
        twin->to = c.from + std::max(known.high, part.high) * along;
        if (c.order < twin->order) {
            twin->curve = id;
            twin->order = c.order;
        }
    }
    std::ranges::stable_sort(segments, {}, &CurveSegment::curve);
    return segments;
}

} // namespace penumbra
