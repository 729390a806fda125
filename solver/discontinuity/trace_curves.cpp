#include "discontinuity/trace_curves.h"

#include "core/parallel.h"
#include "discontinuity/hidden_pairs.h"
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

constexpr Effect parts[] = {Effect::curves_ve_ev, Effect::curves_eee, Effect::curves_contact};

/// Whether one of the two reaches behind the other's plane: then that plane throws a curve of its own.
bool crosses_planes(const Scene &scene, SurfaceId source, SurfaceId receiver) {
    const Surface &a = scene.surface(source), &b = scene.surface(receiver);
    const auto behind = [](const Surface &s, const PlaneFrame &plane) {
        return std::ranges::any_of(s.corners, [&](const Vec3 &x) { return plane.height(x) < -coincidence; });
    };
    return behind(a, b.frame) || behind(b, a.frame);
}

std::vector<Curve> traced(const Scene &scene, SurfaceId source, SurfaceId receiver, std::span<const SurfaceId> blockers,
                          const EffectSwitches &switches, Work &work, const Cancel *cancel) {
    const SourceView view = source_view(scene, source, receiver, blockers);
    const auto wanted = [&](Effect part, bool called_for) {
        if (switches[part] == Switch::off)
            return false;
        const bool done = (called_for && !view.empty()) || switches[part] == Switch::on;
        ++(done ? work.traced_pairs : work.spared[part]);
        return done;
    };
    const auto stands_on_receiver = [&](const Facet &facet) {
        return std::ranges::any_of(facet.corners, [&](const Vec3 &x) { return view.receiver_plane.height(x) < coincidence; });
    };
    const bool ve_ev = wanted(Effect::curves_ve_ev, !view.facets.empty() || crosses_planes(scene, source, receiver));
    const bool eee = wanted(Effect::curves_eee, view.facets.size() > 1);
    const bool contact = wanted(Effect::curves_contact, std::ranges::any_of(view.facets, stands_on_receiver));
    if (view.empty())
        return {};
    const SightCells cells(scene, view, cancel);
    std::vector<Curve> curves;
    if (ve_ev) {
        trace_corners(scene, view, cells, curves);
        trace_edges(scene, view, cells, curves);
    }
    if (eee)
        trace_triples(scene, view, cells, curves);
    if (ve_ev) {
        trace_horizon(scene, view, curves);
        trace_planes(scene, view, cells, curves);
    }
    if (contact)
        trace_contacts(scene, view, cells, curves);
    return merge_curves(curves);
}

} // namespace

std::vector<Curve> trace_curves(const Scene &scene, SurfaceId source, SurfaceId receiver,
                                std::span<const SurfaceId> blockers, const Cancel *cancel,
                                const EffectSwitches &switches) {
    Work work;
    return traced(scene, source, receiver, blockers, switches, work, cancel);
}

std::vector<SurfaceId> possible_blockers(const Scene &scene, SurfaceId source, SurfaceId receiver) {
    return possible_blockers(boxes_of(scene), source, receiver);
}

std::vector<Curve> trace_emitter_curves(const Scene &scene, const EffectSwitches &switches, Work &work,
                                        const Cancel *cancel) {
    std::vector<std::pair<SurfaceId, SurfaceId>> pairs;
    for (int r = 0; r < scene.n_surfaces(); ++r)
        for (int s = 0; s < scene.n_surfaces(); ++s)
            if (r != s && scene.reflects(SurfaceId(r)) && scene.emits(SurfaceId(s)))
                pairs.emplace_back(s, r);
    const std::vector<Eigen::AlignedBox3d> boxes = boxes_of(scene);
    const HiddenPairs hidden_pairs(scene);
    std::vector<std::vector<Curve>> found(pairs.size());
    std::vector<Work> works(pairs.size());
    parallel_for(pairs.size(), [&](std::size_t i) {
        if (cancel)
            cancel->check();
        const auto [source, receiver] = pairs[i];
        const bool sees = face_each_other(scene.surface(source), scene.surface(receiver)) &&
                          !hidden_pairs.hidden(source, receiver);
        if (sees)
            found[i] = traced(scene, source, receiver, possible_blockers(boxes, source, receiver), switches, works[i], cancel);
        else
            for (const Effect part : parts)
                if (switches[part] != Switch::off)
                    ++(switches[part] == Switch::on ? works[i].traced_pairs : works[i].spared[part]);
    });
    std::vector<Curve> all;
    for (std::vector<Curve> &curves : found)
        std::ranges::move(curves, std::back_inserter(all));
    for (const Work &w : works)
        work += w;
    return all;
}

std::vector<Curve> trace_emitter_curves(const Scene &scene, const Cancel *cancel) {
    Work work;
    return trace_emitter_curves(scene, {}, work, cancel);
}

} // namespace penumbra
