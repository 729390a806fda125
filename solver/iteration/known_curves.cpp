#include "iteration/known_curves.h"

#include "core/parallel.h"
#include "discontinuity/trace_curves.h"
#include "iteration/take_snapshot.h"

#include <algorithm>
#include <iterator>

namespace penumbra {

namespace {

constexpr std::size_t most_blockers = 60; // between a reflector and a receiver; more are counted as untraced

void add(const Scene &scene, State &state, std::vector<Curve> found) {
    std::vector<Curve> curves;
    std::vector<SnapshotCurve> drawn;
    if (state.curves) {
        curves = state.curves->curves();
        drawn = *state.drawn_curves;
    }
    for (Curve &curve : found) {
        drawn.push_back(draw_curve(scene, curve));
        curves.push_back(std::move(curve));
    }
    state.curves = std::make_shared<const CurveIndex>(std::move(curves), scene.n_surfaces());
    state.drawn_curves = std::make_shared<const std::vector<SnapshotCurve>>(std::move(drawn));
}

} // namespace

void trace_emitters(const Setting &setting, State &state, const Cancel *cancel) {
    const Scene &scene = *setting.scene;
    Work work;
    add(scene, state, trace_emitter_curves(scene, setting.options.effects, work, cancel));
    state.counters.work += work;
    state.counters.total_work += work;
    std::vector<char> from_emitters;
    for (int s = 0; s < scene.n_surfaces(); ++s)
        from_emitters.push_back(scene.emits(SurfaceId(s)));
    state.traced.assign(scene.surfaces.size(), from_emitters);
}

void trace_paths(const Setting &setting, State &state, std::vector<LightPath> paths, const Cancel *cancel) {
    const Scene &scene = *setting.scene;
    std::ranges::sort(paths);
    paths.erase(std::ranges::unique(paths).begin(), paths.end());
    std::erase_if(paths, [&](const LightPath &p) { return state.traced[p.receiver.at()][p.source.at()] != 0; });
    if (paths.empty())
        return;
    std::vector<std::vector<Curve>> found(paths.size());
    std::vector<char> too_many(paths.size(), 0);
    parallel_for(paths.size(), [&](std::size_t i) {
        if (cancel)
            cancel->check();
        const auto &[receiver, source] = paths[i];
        const std::vector<SurfaceId> blockers = possible_blockers(scene, source, receiver);
        if (blockers.size() <= most_blockers)
            found[i] = trace_curves(scene, source, receiver, blockers, cancel, setting.options.effects);
        else
            too_many[i] = 1;
    });
    std::vector<Curve> all;
    for (std::vector<Curve> &curves : found)
        std::ranges::move(curves, std::back_inserter(all));
    add(scene, state, std::move(all));
    state.counters.work.traced_reflectors += static_cast<std::int64_t>(paths.size());
    state.n_untraced += static_cast<int>(std::ranges::count(too_many, 1));
    for (const LightPath &p : paths)
        state.traced[p.receiver.at()][p.source.at()] = 1;
}

} // namespace penumbra
