#include "study/replay.h"

#include "core/check.h"
#include "core/parallel.h"
#include "iteration/take_snapshot.h"

#include <limits>
#include <algorithm>
#include <utility>

namespace penumbra {

namespace {

constexpr double link_accuracy = 1e-9;

/// From a surface's plane in one scene to its plane in the other.
class PlaneMap {
public:
    PlaneMap(const Scene &from, const Scene &to, SurfaceId s, const Similarity &map)
        : from_(from), to_(to), surface_(s), map_(map) {}

    bool mirrors() const { return map_.linear().determinant() < 0; }
    Vec2 operator()(const Vec2 &p) const {
        const Vec3 own = map_ * from_.own.to_own(from_.surface(surface_).frame.to_space(p));
        return to_.surface(surface_).frame.to_plane(to_.own.to_solver(own));
    }
    Polygon operator()(const Polygon &polygon) const {
        Polygon out;
        for (const Vec2 &p : polygon)
            out.push_back((*this)(p));
        if (mirrors())
            std::reverse(out.begin() + 1, out.end());
        return out;
    }
    BilinearQuad operator()(const BilinearQuad &quad) const {
        BilinearQuad out;
        for (std::size_t k = 0; k < 4; ++k)
            out.corners[mirrors() ? (4 - k) % 4 : k] = (*this)(quad.corners[k]);
        return out;
    }

private:
    const Scene &from_, &to_;
    SurfaceId surface_;
    const Similarity &map_;
};

/// In the frame of its parent, where it has one: as cuts make it.
ElementBasis mapped(const Element &e, const Element *parent, const PlaneMap &map) {
    if (const BilinearQuad *quad = e.basis.quad())
        return {e.basis.order(), map(*quad)};
    Polygon polygon = map(e.basis.outline());
    if (!parent)
        return {e.basis.order(), PlanarDomain(polygon)};
    const PlanarDomain &domain = parent->basis.planar()->domain;
    for (Vec2 &p : polygon)
        p = domain.from_plane(p);
    return {e.basis.order(), domain.part(polygon)};
}

Forest mapped(const Forest &forest, const Scene &from, const Scene &to, const Similarity &map) {
    Forest out = forest;
    for (Element &e : out.elements) {
        const Element *parent = e.parent.valid() ? &out[e.parent] : nullptr;
        e.basis = mapped(e, parent, PlaneMap(from, to, e.surface, map));
        if (parent)
            e.filters = std::make_shared<const TwoScale>(two_scale(parent->basis, e.basis));
    }
    return out;
}

void link_again(const Setting &setting, const State &decisions, State &state, const Cancel *cancel) {
    Transport transport = setting.transport(decisions.counters.threshold, cancel);
    transport.accuracy = transport.constant_accuracy = link_accuracy;
    state.interactions.resize(decisions.interactions.size());
    parallel_for(decisions.interactions.size(), [&](std::size_t e) {
        Work work;
        for (const auto &decided : decisions.interactions[e]) {
            std::vector<ElementId> sources;
            constexpr double everything = std::numeric_limits<double>::infinity(), nothing = -1;
            for (const Link &link : decided->links)
                sources.push_back(link.source);
            const auto candidates = all_candidates(transport, state.forest[ElementId(e)].surface, decided->source);
            state.interactions[e].push_back(connect(transport, state.forest, ElementId(e), decided->source, candidates,
                                                    sources, {decided->weak ? everything : nothing}, work, nullptr, decided->fit));
        }
    });
}

void settle(const Setting &setting, State &state, const Cancel *cancel) {
    for (int step = 0; step < 1000; ++step) {
        gather(setting, state, cancel);
        push_pull(setting, state);
        if (state.counters.change <= 1e-15)
            return;
    }
}

} // namespace

Faces mapped(const Faces &faces, const Similarity &map) {
    Faces out = faces;
    for (Face &face : out) {
        for (Vec3 &corner : face.corners)
            corner = map * corner;
        if (map.linear().determinant() < 0)
            std::ranges::reverse(face.corners);
    }
    return out;
}

Trial replay(const Trial &decided, const Faces &faces, const Similarity &map) {
    const auto scene = std::make_shared<const Scene>(build_scene(mapped(faces, map), decided.scene->name));
    PENUMBRA_CHECK(scene->n_surfaces(), ==, decided.scene->n_surfaces());
    const Cancel *cancel = decided.setting.cancel;
    Setting setting{scene, decided.setting.options, std::make_unique<const Blockers>(*scene)};
    setting.options.gather = GatherOrder::jacobi; // all have one fixed point; this one starts from any radiosity
    auto state = std::make_shared<State>();
    state->counters = decided.state->counters;
    state->curves = decided.state->curves;
    state->drawn_curves = decided.state->drawn_curves;
    state->forest = mapped(decided.state->forest, *decided.scene, *scene, map);
    link_again(setting, *decided.state, *state, cancel);
    state->irradiance.setZero(state->forest.n_coefficients, 3);
    push_pull(state->forest, *scene, state->irradiance, state->radiosity);
    settle(setting, *state, cancel);
    auto snapshot = take_snapshot(setting, *state);
    return {decided.setting, scene, std::move(state), std::move(snapshot)};
}

} // namespace penumbra
