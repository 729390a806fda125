#include "study/find_reference.h"

#include "iteration/solver.h"
#include "iteration/state.h"

#include <algorithm>

namespace penumbra {

std::shared_ptr<const Reference> find_reference(const std::shared_ptr<const Scene> &scene, double tolerance,
                                                const Cancel *cancel,
                                                const std::function<void(const Counters &)> &told) {
    if (has_one_bounce(*scene))
        return std::make_shared<const Reference>(scene);
    Options options;
    options.basis = BasisFamily::planar;
    Solver solver(scene, options.to_tolerance(tolerance), cancel);
    while (!solver.ended() && solver.counters().iteration < options.max_iterations) {
        solver.step(cancel);
        if (told)
            told(solver.counters());
    }
    double rho = 0;
    for (int s = 0; s < scene->n_surfaces(); ++s)
        rho = std::max(rho, scene->reflectance(SurfaceId(s)).maxCoeff());
    const double error = std::max(solver.counters().estimated_error, 0.0);
    const auto state = solver.state();
    return std::make_shared<const Reference>(scene, std::make_shared<const Forest>(state->forest), state->radiosity,
                                             rho * (error > 0 ? error : tolerance));
}

} // namespace penumbra
