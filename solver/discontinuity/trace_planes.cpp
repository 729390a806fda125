#include "discontinuity/trace_planes.h"

#include "discontinuity/edge_on.h"
#include "discontinuity/receiver_line.h"

#include <numeric>

namespace penumbra {

namespace {

void emit(const SourceView &view, const Wedge &plane, IntervalSet line, const std::vector<SurfaceId> &blockers,
          std::vector<Curve> &curves) {
    line.drop_shorter(shortest_curve);
    for (const Interval &i : line.intervals())
        curves.push_back({CurveKind::plane, 1, view.source, view.receiver, blockers,
                          view.receiver_plane.to_plane(plane.on_receiver(i.low)),
                          view.receiver_plane.to_plane(plane.on_receiver(i.high))});
}

void trace_source_plane(const Scene &scene, const SourceView &view, std::vector<Curve> &curves) {
    const auto plane = plane_of(view.source_parts[0], view.receiver_plane);
    if (!plane)
        return;
    IntervalSet line = lit_part(scene, view, plane->foot, plane->along);
    if (line.empty())
        return;
    const int front = plane->normal.dot(view.source_plane.normal) > 0 ? 1 : -1;
    std::vector<std::size_t> all(view.facets.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    EdgeOnScene flat = edge_on_scene(view, all, *plane, front);
    flat.targets.clear();
    for (const Facet &part : view.source_parts)
        flat.targets.push_back(flattened(*plane, part.corners));
    emit(view, *plane, edge_on_sight(flat, std::move(line)), {}, curves);
}

void trace_blocker_plane(const Scene &scene, const SourceView &view, const SightCells &cells,
                         const Encounter &encounter, std::vector<Curve> &curves) {
    const Facet &blocker = view.facets[encounter.touched[0]];
    const auto plane = plane_of(blocker, view.receiver_plane);
    if (!plane)
        return;
    IntervalSet line = cells.line_inside(encounter, plane->foot, plane->along);
    line.clip(lit_part(scene, view, plane->foot, plane->along));
    if (line.empty())
        return;
    EdgeOnScene flat = edge_on_scene(view, cells.facets(encounter), *plane);
    flat.masks = {flattened(*plane, blocker.corners)};
    emit(view, *plane, edge_on_sight(flat, std::move(line)), {blocker.surface}, curves);
}

} // namespace

void trace_planes(const Scene &scene, const SourceView &view, const SightCells &cells, std::vector<Curve> &curves) {
    trace_source_plane(scene, view, curves);
    for (const Encounter &encounter : cells.planes()) {
        cells.check_cancel();
        trace_blocker_plane(scene, view, cells, encounter, curves);
    }
}

} // namespace penumbra
