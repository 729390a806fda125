#include "render/event_words.h"

#include "discontinuity/curve.h"
#include "iteration/critical_surface.h"
#include "iteration/curve_words.h"

#include <algorithm>
#include <vector>

namespace penumbra {
namespace {

std::string owner(const Snapshot &snapshot, const SnapshotEdge &edge) {
    return edge.surface < 0 ? "a blocker" : surface_name(snapshot, edge.surface);
}

std::string blockers(const Snapshot &snapshot, const SnapshotCurve &curve) {
    std::vector<std::string> names;
    for (const std::int32_t b : curve.blockers)
        names.push_back(surface_name(snapshot, b));
    return listed(names);
}

/// Whose edges and corners are touched.
std::string owners(const Snapshot &snapshot, const SnapshotCurve &curve) {
    std::vector<std::string> names;
    for (const SnapshotEdge &edge : curve.touched)
        names.push_back(owner(snapshot, edge));
    return listed(names);
}

std::string sentence(const Snapshot &snapshot, const SnapshotCurve &curve) {
    const auto kind = static_cast<CurveKind>(curve.kind);
    const SnapshotEdge *corner = touched(curve, true), *edge = touched(curve, false);
    const bool in_plane = !corner && curve.touched.size() > 1;
    if (in_plane && (kind == CurveKind::ve || kind == CurveKind::ev))
        return "From this line edges of " + owners(snapshot, curve) + " lie exactly one behind the other.";
    const std::string of_corner = corner ? owner(snapshot, *corner) : "", of_edge = edge ? owner(snapshot, *edge) : "";
    switch (kind) {
    case CurveKind::ve:
        return corner && edge
                   ? "Crossing this line, a corner of " + of_corner + " goes behind an edge of " + of_edge + "."
                   : "Crossing this line, a corner goes behind an edge of " + blockers(snapshot, curve) + ".";
    case CurveKind::ev:
        return corner && edge
                   ? "Crossing this line, a corner of " + of_corner + " comes before an edge of " + of_edge + "."
                   : "Crossing this line, a corner of " + blockers(snapshot, curve) + " comes before an edge.";
    case CurveKind::eee: {
        const std::string of = curve.touched.empty()
                                   ? surface_name(snapshot, curve.source) + " and " + blockers(snapshot, curve)
                                   : owners(snapshot, curve);
        return "From this line three edges, of " + of + ", seem to meet in one point.";
    }
    case CurveKind::plane:
        return "From this line " + surface_name(snapshot, critical_surface(snapshot, curve, 2).edge_on) +
               " is seen exactly edge-on.";
    case CurveKind::contact:
        return "Along this line " + blockers(snapshot, curve) + " touches " + surface_name(snapshot, curve.receiver) +
               ".";
    }
    return {};
}

Vec3 middle_of(const SnapshotSurface &s) {
    Vec2 sum = Vec2::Zero();
    for (const Vec2 &p : s.outline)
        sum += p / static_cast<double>(s.outline.size());
    return s.origin + sum.x() * s.u + sum.y() * s.v;
}

/// Whether, as seen from x, the corner lies on that side of the edge on which the edge's surface is.
bool within(const Snapshot &snapshot, const SnapshotEdge &corner, const SnapshotEdge &edge, const Vec3 &x) {
    const Vec3 across = (edge.a - x).cross(edge.b - x);
    const Vec3 middle = middle_of(snapshot.surfaces[static_cast<std::size_t>(edge.surface)]);
    return across.dot(corner.a - x) * across.dot(middle - x) > 0;
}

std::string happened(const Snapshot &snapshot, const SnapshotCurve &curve, const Vec3 &here) {
    const SnapshotEdge *corner = touched(curve, true), *edge = touched(curve, false);
    const auto kind = static_cast<CurveKind>(curve.kind);
    if ((kind == CurveKind::ve || kind == CurveKind::ev) && corner && edge && edge->surface >= 0) {
        const bool in = within(snapshot, *corner, *edge, here);
        const char *const did = kind == CurveKind::ve
                                    ? (in ? " went behind an edge of " : " came out from behind an edge of ")
                                    : (in ? " moved in before an edge of " : " moved out across an edge of ");
        return "A corner of " + owner(snapshot, *corner) + did + owner(snapshot, *edge);
    }
    if (kind == CurveKind::eee) {
        return "Three edges, of " + owners(snapshot, curve) + ", passed through one point";
    }
    if (!corner && curve.touched.size() > 1)
        return "Edges of " + owners(snapshot, curve) + " passed one behind the other";
    if (kind == CurveKind::plane)
        return surface_name(snapshot, critical_surface(snapshot, curve, 2).edge_on) + " was seen edge-on";
    return "The point has passed where " + blockers(snapshot, curve) + " stands";
}

std::string jump(int order) {
    constexpr const char *what[] = {"irradiance itself", "slope of the irradiance", "curvature of the irradiance"};
    return std::string("Across it the ") + what[std::clamp(order, 0, 2)] + " jumps.";
}

std::string symbol(const SnapshotCurve &curve) {
    constexpr const char *orders[] = {"D\u2070", "D\u00b9", "D\u00b2"};
    return std::string(name(static_cast<CurveKind>(curve.kind))) + ", " + orders[std::clamp(curve.order, 0, 2)];
}

std::string way(const Snapshot &snapshot, const SnapshotCurve &curve) {
    const std::string past = blockers(snapshot, curve);
    return surface_name(snapshot, curve.source) + " \u2192 " + surface_name(snapshot, curve.receiver) +
           (past.empty() ? "" : ", past " + past);
}

} // namespace

std::string surface_name(const Snapshot &snapshot, int surface) {
    if (surface < 0 || surface >= static_cast<int>(snapshot.surfaces.size()))
        return "a surface";
    const std::string &name = snapshot.surfaces[static_cast<std::size_t>(surface)].name;
    return name.empty() ? "surface " + std::to_string(surface) : name;
}

EventWords crossing_words(const Snapshot &snapshot, const SnapshotCurve &curve, const Vec3 &here) {
    return {happened(snapshot, curve, here) + ".", "", symbol(curve), way(snapshot, curve)};
}

EventWords event_words(const Snapshot &snapshot, const SnapshotCurve &curve) {
    return {sentence(snapshot, curve), jump(curve.order), symbol(curve), way(snapshot, curve)};
}

} // namespace penumbra
