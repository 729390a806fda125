#include "iteration/state.h"

#include "core/check.h"
#include "core/parallel.h"

namespace penumbra {

Coefficients gathered(const State &state, const Coefficients &radiosity, const Cancel *cancel) {
    PENUMBRA_CHECK(state.batches.size(), ==, state.forest.elements.size());
    Coefficients irradiance = Coefficients::Zero(state.forest.n_coefficients, 3);
    parallel_for(state.batches.size(), [&](std::size_t e) {
        if (cancel)
            cancel->check();
        const Element &element = state.forest.elements[e];
        if (state.batches[e])
            state.batches[e]->add_irradiance(radiosity, irradiance.middleRows(element.first, element.basis.n_functions()));
    });
    return irradiance;
}

void gather(const Setting &, State &state, const Cancel *cancel) {
    renew(state.batches, state.forest, state.interactions, cancel);
    state.irradiance = gathered(state, state.radiosity, cancel);
    state.counters.link_bytes = link_bytes(state.interactions, state.batches);
    state.sentence = "gathered over " + std::to_string(state.counters.links) + " links";
}

} // namespace penumbra
