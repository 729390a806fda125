#include "iteration/state.h"

#include "core/parallel.h"

namespace penumbra {

Coefficients gathered(const State &state, const Coefficients &radiosity, const Cancel *cancel) {
    Coefficients irradiance = Coefficients::Zero(state.forest.n_coefficients, 3);
    parallel_for(state.forest.elements.size(), [&](std::size_t e) {
        if (cancel)
            cancel->check();
        const Element &element = state.forest.elements[e];
        auto here = irradiance.middleRows(element.first, element.basis.n_functions());
        for (const auto &interaction : state.interactions[e])
            here += interaction->irradiance(state.forest, radiosity);
    });
    return irradiance;
}

void gather(const Setting &, State &state, const Cancel *cancel) {
    state.irradiance = gathered(state, state.radiosity, cancel);
    state.sentence = "gathered over " + std::to_string(state.counters.links) + " links";
}

} // namespace penumbra
