#include "iteration/truth.h"

#include "iteration/patch_finder.h"
#include "iteration/solver.h"
#include "iteration/state.h"
#include "measure/leaf_at.h"

#include <utility>

namespace penumbra {

Truth truth_of(std::shared_ptr<const Scene> scene, std::shared_ptr<const Reference> reference) {
    const double error = reference->error();
    return {[scene = std::move(scene), reference = std::move(reference)](int surface, const Vec2 &point) {
                return reference->radiosity_at(SurfaceId(surface), point / scene->own.size);
            },
            error};
}

Truth with_change(std::shared_ptr<const Scene> scene, Options options, const EffectChange &change, const Cancel *cancel,
                  const std::function<void(const Counters &)> &told) {
    options.effects[change.effect] = change.to;
    Solver solver(scene, options, cancel);
    while (!solver.ended() && solver.counters().iteration < options.max_iterations) {
        solver.step(cancel);
        if (told)
            told(solver.counters());
    }
    return {[scene = std::move(scene), state = solver.state()](int surface, const Vec2 &point) {
                return radiosity_at(state->forest, state->radiosity, SurfaceId(surface), point / scene->own.size);
            },
            0, change};
}

Truth truth_in(std::shared_ptr<const Snapshot> snapshot) {
    const std::uint64_t version = snapshot->version;
    const auto finder = std::make_shared<const PatchFinder>(std::move(snapshot));
    return {[finder](int surface, const Vec2 &point) {
                const SnapshotPatch *patch = finder->patch_at(surface, point);
                return patch ? radiosity(finder->snapshot(), *patch, point) : Rgb(Rgb::Zero());
            },
            0, std::nullopt, version};
}

} // namespace penumbra
