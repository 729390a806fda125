#include "study/solve_for_reference.h"

#include "iteration/measure_error.h"
#include "iteration/solver.h"
#include "iteration/state.h"

namespace penumbra {

ConvergedSolution solve_for_reference(const std::shared_ptr<const Scene> &scene, double tolerance, const Cancel *cancel,
                                      const ReferenceProgress &told) {
    Solver solver(scene, Options().to_tolerance(tolerance), cancel);
    while (!solver.ended() && solver.counters().iteration < solver.options().max_iterations) {
        solver.step(cancel);
        if (told)
            told(solver.counters());
    }
    const auto state = solver.state();
    const Setting setting{scene, solver.options(), std::make_unique<const Blockers>(*scene),
                          std::make_unique<const RayScene>(*scene)};
    constexpr std::uint64_t seed = 0x7e5; // points of its own, not those that the solver stopped at
    Work work;
    const ErrorEstimate e = measure_error(setting, *state, tolerance, seed, cancel, work);
    return {std::make_shared<const Forest>(state->forest), state->radiosity, e.bounced};
}

} // namespace penumbra
