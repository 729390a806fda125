#include "discontinuity/curve_index.h"

#include "discontinuity/merge_curves.h"
#include "discontinuity/receiver_line.h"

#include <algorithm>

namespace penumbra {

namespace {

/// The curve's part inside; empty also when it runs along the border.
Interval part_inside(const Curve &curve, const Vec2 &along, double length, const Polygon &convex) {
    for (std::size_t i = 0; i < convex.size(); ++i) {
        const Vec2 edge = (convex[(i + 1) % convex.size()] - convex[i]);
        const double slack = 2 * coincidence * edge.norm();
        // Wholly on or outside one side: the common case, and the border's.
        if (cross(edge, curve.from - convex[i]) <= slack && cross(edge, curve.to - convex[i]) <= slack)
            return {0, 0};
    }
    return overlap(inside(convex, curve.from, along), {0, length});
}

} // namespace

CurveIndex::CurveIndex(std::vector<Curve> curves, int n_surfaces)
    : curves_(std::move(curves)), by_receiver_(static_cast<std::size_t>(n_surfaces)) {
    for (std::size_t c = 0; c < curves_.size(); ++c)
        by_receiver_[curves_[c].receiver.at()].emplace_back(c);
}

std::vector<CurveSegment> CurveIndex::crossing(SurfaceId receiver, const Polygon &convex,
                                               std::span<const SurfaceId> sources) const {
    std::vector<CurveSegment> segments;
    for (const CurveId id : on_receiver(receiver)) {
        const Curve &c = curve(id);
        if (std::ranges::find(sources, c.source) == sources.end())
            continue;
        const double length = (c.to - c.from).norm();
        const Vec2 along = (c.to - c.from) / length;
        const Interval part = part_inside(c, along, length, convex);
        if (part.length() < shortest_curve)
            continue;
        const auto twin = std::ranges::find_if(segments, [&](const CurveSegment &s) {
            return curve(s.curve).source != c.source && in_line(curve(s.curve), c);
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
    std::ranges::sort(segments, {}, &CurveSegment::curve);
    return segments;
}

} // namespace penumbra
