#include "iteration/relaxation.h"

#include "core/parallel.h"

namespace penumbra {

Coefficients gathered_in_turn(const Setting &setting, const State &state, const Cancel *cancel) {
    const Forest &forest = state.forest;
    Coefficients irradiance = Coefficients::Zero(forest.n_coefficients, 3), pushed = irradiance;
    Coefficients radiosity = state.radiosity;
    for (const auto &surface : elements_by_surface(forest)) {
        if (surface.empty() || !setting.scene->reflects(forest[surface.front()].surface))
            continue;
        parallel_for(surface.size(), [&](std::size_t i) {
            if (cancel)
                cancel->check();
            if (const auto &batch = state.batches[surface[i].at()])
                batch->add_irradiance(radiosity, rows(forest[surface[i]], irradiance));
        });
        push_pull(forest, *setting.scene, surface, irradiance, pushed, radiosity);
    }
    return irradiance;
}

} // namespace penumbra
