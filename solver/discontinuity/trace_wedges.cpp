#include "discontinuity/trace_wedges.h"

#include "discontinuity/receiver_line.h"
#include "discontinuity/sectors.h"
#include "discontinuity/sweep.h"
#include "discontinuity/wedge.h"

#include <algorithm>
#include <cmath>

namespace penumbra {

namespace {

/// A corner with the facets that meet there.
struct Apex {
    const SightCorner *corner;
    std::vector<std::size_t> facets; ///< ascending
    std::vector<FacetCone> cones;

    Apex(const SourceView &view, const SightCorner &c) : corner(&c) {
        for (std::size_t f = 0; f < view.facets.size(); ++f)
            if (touches(view.facets[f], c.at)) {
                facets.push_back(f);
                cones.push_back(cone_at(view.facets[f], c.at));
            }
    }
    /// Whether an edge that leaves the corner lies in the wedge's plane.
    bool has_edge_in(const Wedge &wedge) const {
        return std::ranges::any_of(corner->neighbours, [&](const Vec3 &end) { return wedge.side(end) == 0; });
    }
};

void add_id(std::vector<SurfaceId> &ids, SurfaceId id) {
    const auto place = std::ranges::lower_bound(ids, id);
    if (place == ids.end() || *place != id)
        ids.insert(place, id);
}

/// Cuts the line where the sectors that the cones fill may change order: in the planes of any two of their rays.
void split_between_rays(IntervalSet &line, const Wedge &wedge, std::span<const FacetCone> cones) {
    std::vector<Vec3> rays;
    for (const FacetCone &cone : cones)
        if (!cone.whole) {
            rays.push_back(cone.first.normalized());
            rays.push_back(cone.second.normalized());
        }
    for (std::size_t i = 0; i < rays.size(); ++i)
        for (std::size_t j = i + 1; j < rays.size(); ++j) {
            const Vec3 across = rays[i].cross(rays[j]);
            const double rate = wedge.along.dot(across);
            if (std::abs(rate) > coincidence)
                line.split((wedge.apex - wedge.foot).dot(across) / rate);
        }
}

void emit(const SourceView &view, const Wedge &wedge, const IntervalSet &line, CurveKind kind, int order,
          const std::vector<SurfaceId> &blockers, std::vector<Curve> &curves) {
    for (const Interval &i : line.intervals())
        curves.push_back({kind, order, view.source, view.receiver, blockers,
                          view.receiver_plane.to_plane(wedge.on_receiver(i.low)),
                          view.receiver_plane.to_plane(wedge.on_receiver(i.high))});
}

/// Keeps the pieces at whose middle the test holds; what was cut only for the test grows together again.
template <class Test>
void keep_where(IntervalSet &line, const Test &test) {
    IntervalSet kept;
    for (const Interval &i : line.intervals())
        if (test(i.middle()))
            kept.unite(i);
    line = std::move(kept);
}

Vec3 direction_of_line(const Wedge &wedge, double s) { return (wedge.on_receiver(s) - wedge.apex).normalized(); }

void trace_over(const Scene &scene, const SourceView &view, const Apex &apex, const SightEdge &edge,
                std::vector<Curve> &curves) {
    const auto wedge = make_wedge(apex.corner->at, edge.a, edge.b, view.receiver_plane);
    if (!wedge)
        return;
    IntervalSet line(wedge->below(edge.from(), edge.to()));
    if (line.empty())
        return;
    line.clip(lit_part(scene, view, wedge->foot, wedge->along));
    if (line.empty())
        return;
    Sweep fan = sweep(view, *wedge, Reach::to_apex, apex.facets, std::move(line));
    close_folds(fan);
    // The edge's own faces stand on one side only, or it is no silhouette; folds are closed already.
    IntervalSet own;
    std::vector<SurfaceId> blockers;
    for (const Graze &graze : fan.grazes)
        if (on_line(graze, edge.a, edge.b)) {
            own.unite(graze.lines, shortest_curve);
            add_id(blockers, graze.surface);
        }
    fan.open.clip(own);
    if (!apex.cones.empty()) {
        std::vector<FacetCone> source_cones;
        for (const Facet &part : view.source_parts)
            if (touches(part, apex.corner->at))
                source_cones.push_back(cone_at(part, apex.corner->at));
        split_between_rays(fan.open, *wedge, apex.cones);
        split_between_rays(fan.open, *wedge, source_cones);
        keep_where(fan.open, [&](double s) {
            const Vec3 d = direction_of_line(*wedge, s);
            return shows_any(source_cones, apex.corner->at, d, free_sectors(apex.cones, apex.corner->at, d));
        });
    }
    fan.open.drop_shorter(shortest_curve);
    emit(view, *wedge, fan.open, CurveKind::ve, apex.has_edge_in(*wedge) ? 1 : 2, blockers, curves);
}

void trace_through(const Scene &scene, const SourceView &view, const Apex &apex, const SightEdge &edge,
                   std::vector<Curve> &curves) {
    const auto wedge = make_wedge(apex.corner->at, edge.a, edge.b, view.receiver_plane);
    if (!wedge)
        return;
    IntervalSet line(wedge->above(edge.from(), edge.to()));
    if (line.empty())
        return;
    line.clip(lit_part(scene, view, wedge->foot, wedge->along));
    if (line.empty())
        return;
    split_between_rays(line, *wedge, apex.cones);
    keep_where(line, [&](double s) {
        return shows_corner(free_sectors(apex.cones, apex.corner->at, direction_of_line(*wedge, s)));
    });
    if (line.empty())
        return;
    Sweep fan = sweep(view, *wedge, Reach::beyond_apex, apex.facets, std::move(line));
    close_folds(fan);
    // A facet that hangs from the source's edge on the source's side hides all that the edge borders.
    int source_side = 0;
    for (const Facet &part : view.source_parts)
        if (touches(part, edge.point(edge.part.middle())))
            source_side = wedge->side(part.centre);
    for (const Graze &graze : fan.grazes)
        if (graze.side == source_side && on_line(graze, edge.a, edge.b))
            fan.open.subtract(graze.lines);
    fan.open.drop_shorter(shortest_curve);
    std::vector<SurfaceId> blockers;
    for (const std::size_t f : apex.facets)
        add_id(blockers, view.facets[f].surface);
    emit(view, *wedge, fan.open, CurveKind::ev, apex.has_edge_in(*wedge) ? 1 : 2, blockers, curves);
}

} // namespace

void trace_source_corners(const Scene &scene, const SourceView &view, std::vector<Curve> &curves) {
    for (const SightCorner &corner : view.source_corners) {
        const Apex apex(view, corner);
        for (const SightEdge &edge : view.blocker_edges)
            trace_over(scene, view, apex, edge, curves);
    }
}

void trace_source_edges(const Scene &scene, const SourceView &view, std::vector<Curve> &curves) {
    for (const SightCorner &corner : view.blocker_corners) {
        const Apex apex(view, corner);
        for (const SightEdge &edge : view.source_edges)
            trace_through(scene, view, apex, edge, curves);
    }
}

} // namespace penumbra
