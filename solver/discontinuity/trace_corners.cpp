#include "discontinuity/trace_corners.h"

#include "discontinuity/crossing.h"
#include "discontinuity/local_picture.h"
#include "discontinuity/receiver_line.h"
#include "discontinuity/wedge.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace penumbra {

namespace {

/// The lines of a wedge as facets are met: those that are still open, and the facets that some of them graze.
struct Fan {
    IntervalSet open;
    std::vector<const Facet *> grazed;
};

/// Takes out the lines that cross the facet, or cuts the set where they begin or cease to graze it.
void meet(const Wedge &wedge, const Facet &facet, Fan &fan) {
    if (std::abs(wedge.height(facet.centre)) > facet.radius + coincidence)
        return;
    const Crossing crossing = cross_facet(wedge, facet);
    if (crossing.n < 2)
        return;
    if (crossing.through()) {
        fan.open.subtract(wedge.below(crossing.p, crossing.q));
        fan.open.subtract(wedge.above(crossing.p, crossing.q));
        return;
    }
    fan.grazed.push_back(&facet);
    const auto split = [&](const Vec3 &p) { fan.open.split(wedge.parameter(p)); };
    if (crossing.along_edge()) {
        split(crossing.p);
        split(crossing.q);
    } else {
        std::ranges::for_each(facet.corners, split);
    }
}

void split_at_source(const Wedge &wedge, const SourceView &view, IntervalSet &line) {
    for (const Facet &part : view.source_parts)
        if (const Crossing crossing = cross_facet(wedge, part); crossing.n >= 2) {
            line.split(wedge.parameter(crossing.p));
            line.split(wedge.parameter(crossing.q));
        }
}

void add_rays(const Facet &facet, const Vec3 &apex, std::vector<Vec3> &rays) {
    const std::size_t n = facet.corners.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Vec3 &a = facet.corners[i], &b = facet.corners[(i + 1) % n];
        if ((b - a).cross(apex - a).norm() > 2 * coincidence * (b - a).norm())
            continue;
        for (const Vec3 &end : {a, b})
            if ((end - apex).norm() > 2 * coincidence)
                rays.push_back((end - apex).normalized());
    }
}

/// Cuts the line where what the facets about the apex hide may change its shape: in the planes of any two of the edges
/// that leave it.
void split_between_rays(const Wedge &wedge, const SourceView &view, std::span<const std::size_t> corner,
                        IntervalSet &line) {
    std::vector<Vec3> rays;
    for (const std::size_t f : corner)
        add_rays(view.facets[f], wedge.apex, rays);
    for (const Facet &part : view.source_parts)
        if (touches(part, wedge.apex))
            add_rays(part, wedge.apex, rays);
    for (std::size_t i = 0; i < rays.size(); ++i)
        for (std::size_t j = i + 1; j < rays.size(); ++j) {
            const Vec3 across = rays[i].cross(rays[j]);
            const double rate = wedge.along.dot(across);
            if (std::abs(rate) > coincidence)
                line.split((wedge.apex - wedge.foot).dot(across) / rate);
        }
}

SightLine line_of(const Wedge &wedge, double s) {
    const Vec3 from = wedge.on_receiver(s);
    return {from, (wedge.apex - from).normalized()};
}

struct RealPart {
    Interval line;
    int order;
    std::vector<SurfaceId> blockers;
};

std::optional<RealPart> real_part(const SourceView &view, const Wedge &wedge, const Interval &line,
                                  std::span<const std::size_t> corner, std::span<const Facet *const> grazed) {
    const SightLine eye = line_of(wedge, line.middle());
    LocalPicture picture(eye, wedge.receiver.normal.cross(wedge.along));
    Meeting source = Meeting::apart;
    for (const Facet &part : view.source_parts)
        if (const Meeting meeting = picture.add_source(part); meeting != Meeting::apart)
            source = meeting;
    if (source == Meeting::apart)
        return std::nullopt;
    for (const std::size_t f : corner)
        if (picture.add_blocker(view.facets[f]) == Meeting::pierced)
            return std::nullopt;
    for (const Facet *facet : grazed)
        if (picture.add_blocker(*facet) == Meeting::pierced)
            return std::nullopt;
    if (!picture.changes())
        return std::nullopt;
    return RealPart{line, picture.kinks(wedge.normal.cross(eye.along)) ? 1 : 2, picture.bounding()};
}

void emit(const SourceView &view, const Wedge &wedge, const RealPart &part, CurveKind kind,
          const std::vector<TouchedEdge> &touched, std::vector<Curve> &curves) {
    if (part.line.length() < shortest_curve)
        return;
    const auto at = [&](double s) { return view.receiver_plane.to_plane(wedge.on_receiver(s)); };
    curves.push_back({kind, part.order, view.source, view.receiver, part.blockers, at(part.line.low),
                      at(part.line.high), Vec3::Zero(), touched});
}

bool in_plane(const PlaneFrame &plane, const Vec3 &p) { return std::abs(plane.height(p)) <= coincidence; }

/// The lines `candidates` of the wedge of a corner and an edge that meet.
void trace_wedge(const Scene &scene, const SourceView &view, const SightCells &cells, const Encounter &encounter,
                 const Wedge &wedge, Interval candidates, CurveKind kind, std::vector<Curve> &curves) {
    const SightCorner &apex = view.corners[encounter.touched[0]];
    const SightEdge &edge = view.edges[encounter.touched[1]];
    const std::span<const std::size_t> corner = apex.facets, first = edge.facets;
    Fan fan{IntervalSet(candidates), {}};
    if (fan.open.empty())
        return;
    fan.open.clip(cells.line_inside(encounter, wedge.foot, wedge.along));
    if (fan.open.empty())
        return;
    fan.open.clip(lit_part(scene, view, wedge.foot, wedge.along));
    // The edge's own facets close most lines.
    for (const std::size_t f : first)
        if (!fan.open.empty() && !std::ranges::binary_search(corner, f))
            meet(wedge, view.facets[f], fan);
    if (fan.open.empty())
        return;
    for (const std::size_t f : cells.facets(encounter))
        if (!fan.open.empty() && !std::ranges::binary_search(corner, f) && !std::ranges::binary_search(first, f))
            meet(wedge, view.facets[f], fan);
    if (fan.open.empty())
        return;
    split_between_rays(wedge, view, corner, fan.open);
    split_at_source(wedge, view, fan.open);
    fan.open.drop_shorter(shortest_curve);
    const std::vector<TouchedEdge> touched{{apex.at, apex.at}, {edge.from(), edge.to()}};
    std::optional<RealPart> growing;
    for (const Interval &i : fan.open.intervals()) {
        std::optional<RealPart> part = real_part(view, wedge, i, corner, fan.grazed);
        if (growing && part && part->order == growing->order && part->blockers == growing->blockers &&
            i.low <= growing->line.high) {
            growing->line.high = i.high;
            continue;
        }
        if (growing)
            emit(view, wedge, *growing, kind, touched, curves);
        growing = std::move(part);
    }
    if (growing)
        emit(view, wedge, *growing, kind, touched, curves);
}

} // namespace

void trace_corners(const Scene &scene, const SourceView &view, const SightCells &cells, std::vector<Curve> &curves) {
    for (const Encounter &encounter : cells.corners_and_edges()) {
        cells.check_cancel();
        const SightCorner &corner = view.corners[encounter.touched[0]];
        const SightEdge &edge = view.edges[encounter.touched[1]];
        if (in_plane(view.source_plane, corner.at) && in_plane(view.source_plane, edge.a) &&
            in_plane(view.source_plane, edge.b))
            continue;
        const auto wedge = make_wedge(corner.at, edge.a, edge.b, view.receiver_plane);
        if (!wedge)
            continue;
        trace_wedge(scene, view, cells, encounter, *wedge, wedge->below(edge.from(), edge.to()), CurveKind::ve, curves);
        trace_wedge(scene, view, cells, encounter, *wedge, wedge->above(edge.from(), edge.to()), CurveKind::ev, curves);
    }
}

} // namespace penumbra
