#include "iteration/truth.h"

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

} // namespace penumbra
