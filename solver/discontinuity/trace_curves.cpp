#include "discontinuity/trace_curves.h"

#include "core/parallel.h"
#include "discontinuity/merge_curves.h"
#include "discontinuity/sight_cells.h"
#include "discontinuity/source_view.h"
#include "discontinuity/trace_contacts.h"
#include "discontinuity/trace_horizon.h"
#include "discontinuity/trace_planes.h"
#include "discontinuity/trace_corners.h"
#include "discontinuity/trace_edges.h"
#include "discontinuity/trace_triples.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <iterator>
#include <utility>

namespace penumbra {

namespace {

std::vector<Eigen::AlignedBox3d> boxes_of(const Scene &scene) {
    std::vector<Eigen::AlignedBox3d> boxes;
    for (const Surface &surface : scene.surfaces) {
        Eigen::AlignedBox3d &box = boxes.emplace_back();
        for (const Vec3 &c : surface.corners)
            box.extend(c);
    }
    return boxes;
}

std::vector<SurfaceId> possible_blockers(std::span<const Eigen::AlignedBox3d> boxes, SurfaceId source,
                                         SurfaceId receiver) {
    Eigen::AlignedBox3d both = boxes[source.at()].merged(boxes[receiver.at()]);
    both.min().array() -= coincidence;
    both.max().array() += coincidence;
    std::vector<SurfaceId> blockers;
    for (std::size_t s = 0; s < boxes.size(); ++s)
        if (const SurfaceId id(s); id != source && id != receiver && both.intersects(boxes[s]))
            blockers.push_back(id);
    return blockers;
}

} // namespace

std::vector<Curve> trace_curves(const Scene &scene, SurfaceId source, SurfaceId receiver,
                                std::span<const SurfaceId> blockers) {
    const SourceView view = source_view(scene, source, receiver, blockers);
    if (view.empty())
        return {};
    const SightCells cells(scene, view);
    std::vector<Curve> curves;
    trace_corners(scene, view, cells, curves);
    trace_edges(scene, view, cells, curves);
    trace_triples(scene, view, cells, curves);
    trace_horizon(scene, view, curves);
    trace_planes(scene, view, cells, curves);
    trace_contacts(scene, view, cells, curves);
    return merge_curves(curves);
}

std::vector<SurfaceId> possible_blockers(const Scene &scene, SurfaceId source, SurfaceId receiver) {
    return possible_blockers(boxes_of(scene), source, receiver);
}

std::vector<Curve> trace_emitter_curves(const Scene &scene, const Cancel *cancel) {
    const std::vector<Eigen::AlignedBox3d> boxes = boxes_of(scene);
    std::vector<std::pair<SurfaceId, SurfaceId>> pairs;
    for (int r = 0; r < scene.n_surfaces(); ++r)
        for (int s = 0; s < scene.n_surfaces(); ++s)
            if (r != s && scene.reflects(SurfaceId(r)) && scene.emits(SurfaceId(s)))
                pairs.emplace_back(s, r);
    std::vector<std::vector<Curve>> found(pairs.size());
    parallel_for(pairs.size(), [&](std::size_t i) {
        if (cancel)
            cancel->check();
        const auto [source, receiver] = pairs[i];
        found[i] = trace_curves(scene, source, receiver, possible_blockers(boxes, source, receiver));
    });
    std::vector<Curve> all;
    for (std::vector<Curve> &curves : found)
        std::ranges::move(curves, std::back_inserter(all));
    return all;
}

} // namespace penumbra
