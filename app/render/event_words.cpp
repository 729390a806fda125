#include "render/event_words.h"

#include "discontinuity/curve.h"
#include "iteration/critical_surface.h"

#include <algorithm>
#include <vector>

namespace penumbra {
namespace {

/// "a", "a and b", "a, b and c"; each name once.
std::string listed(const std::vector<std::string> &names) {
    std::vector<std::string> once;
    for (const std::string &name : names)
        if (std::ranges::find(once, name) == once.end())
            once.push_back(name);
    std::string text;
    for (std::size_t i = 0; i < once.size(); ++i)
        text += (i == 0 ? "" : i + 1 < once.size() ? ", " : " and ") + once[i];
    return text;
}

std::string owner(const Snapshot &snapshot, const SnapshotEdge &edge) {
    return edge.surface < 0 ? "a blocker" : surface_name(snapshot, edge.surface);
}

std::string blockers(const Snapshot &snapshot, const SnapshotCurve &curve) {
    std::vector<std::string> names;
    for (const std::int32_t b : curve.blockers)
        names.push_back(surface_name(snapshot, b));
    return listed(names);
}

/// Of the touched ones the corner, or the edge; null where there is none.
const SnapshotEdge *touched(const SnapshotCurve &curve, bool corner) {
    for (const SnapshotEdge &edge : curve.touched)
        if (edge.is_corner() == corner)
            return &edge;
    return nullptr;
}

std::string sentence(const Snapshot &snapshot, const SnapshotCurve &curve) {
    const auto kind = static_cast<CurveKind>(curve.kind);
    const SnapshotEdge *corner = touched(curve, true), *edge = touched(curve, false);
    const std::string of_corner = corner ? owner(snapshot, *corner) : "", of_edge = edge ? owner(snapshot, *edge) : "";
    switch (kind) {
    case CurveKind::ve:
        return corner && edge ? "Crossing this line, a corner of " + of_corner + " goes behind an edge of " + of_edge + "."
                              : "Crossing this line, a corner goes behind an edge of " + blockers(snapshot, curve) + ".";
    case CurveKind::ev:
        return corner && edge ? "Crossing this line, a corner of " + of_corner + " comes before an edge of " + of_edge + "."
                              : "Crossing this line, a corner of " + blockers(snapshot, curve) + " comes before an edge.";
    case CurveKind::eee: {
        std::vector<std::string> names;
        for (const SnapshotEdge &e : curve.touched)
            names.push_back(owner(snapshot, e));
        if (names.empty())
            names = {blockers(snapshot, curve), surface_name(snapshot, curve.source)};
        return "From this line three edges, of " + listed(names) + ", seem to meet in one point.";
    }
    case CurveKind::plane:
        return "From this line " + surface_name(snapshot, critical_surface(snapshot, curve, 2).edge_on) +
               " is seen exactly edge-on.";
    case CurveKind::contact:
        return "Along this line " + blockers(snapshot, curve) + " touches " + surface_name(snapshot, curve.receiver) + ".";
    }
    return {};
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

EventWords event_words(const Snapshot &snapshot, const SnapshotCurve &curve) {
    return {sentence(snapshot, curve), jump(curve.order), symbol(curve), way(snapshot, curve)};
}

} // namespace penumbra
