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
#include <atomic>
#include <functional>
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

/// Pairs of which one surface hides all: of many rooms most pairs stand in different ones, with a wall in between.
class HiddenPairs {
public:
    HiddenPairs(const Scene &scene, std::span<const Eigen::AlignedBox3d> boxes)
        : scene_(scene), boxes_(boxes), last_(scene.surfaces.size()) {
        for (int s = 0; s < scene.n_surfaces(); ++s)
            large_first_.emplace_back(s);
        std::ranges::stable_sort(large_first_, std::greater<>(), [&](SurfaceId s) { return scene.surface(s).area; });
    }

    /// From many threads: which surface it finds may differ, the answer does not.
    bool hidden(SurfaceId source, SurfaceId receiver) {
        const Eigen::AlignedBox3d both = boxes_[source.at()].merged(boxes_[receiver.at()]);
        const auto hides_all = [&](SurfaceId s) {
            return s != source && s != receiver && both.intersects(boxes_[s.at()]) &&
                   hides(scene_.surface(s), scene_.surface(receiver), scene_.surface(source));
        };
        // What hid the last receiver often hides the next.
        if (const SurfaceId last(last_[source.at()].load(std::memory_order_relaxed)); hides_all(last))
            return true;
        const auto found = std::ranges::find_if(large_first_, hides_all);
        if (found == large_first_.end())
            return false;
        last_[source.at()].store(found->index, std::memory_order_relaxed);
        return true;
    }

private:
    const Scene &scene_;
    std::span<const Eigen::AlignedBox3d> boxes_;
    std::vector<SurfaceId> large_first_;
    std::vector<std::atomic<int>> last_; ///< by source; at first surface 0
};

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
    HiddenPairs hidden_pairs(scene, boxes);
    std::vector<std::vector<Curve>> found(pairs.size());
    parallel_for(pairs.size(), [&](std::size_t i) {
        if (cancel)
            cancel->check();
        const auto [source, receiver] = pairs[i];
        if (!face_each_other(scene.surface(source), scene.surface(receiver)) || hidden_pairs.hidden(source, receiver))
            return;
        found[i] = trace_curves(scene, source, receiver, possible_blockers(boxes, source, receiver));
    });
    std::vector<Curve> all;
    for (std::vector<Curve> &curves : found)
        std::ranges::move(curves, std::back_inserter(all));
    return all;
}

} // namespace penumbra
