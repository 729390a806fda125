#include "iteration/relaxation.h"

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

void gather(const Setting &setting, State &state, const Cancel *cancel) {
    const auto renewed = renew(state.batches, state.forest, state.interactions, setting.plan.channels, cancel);
    const std::string n_links = std::to_string(state.counters.links) + " links";
    Work work;
    work.link_evaluations = state.counters.links;
    switch (setting.options.gather) {
    case GatherOrder::jacobi:
        state.irradiance = gathered(state, state.radiosity, cancel);
        state.sentence = "gathered over " + n_links;
        break;
    case GatherOrder::gauss_seidel:
        state.irradiance = gathered_in_turn(setting, state, cancel);
        state.sentence = "gathered over " + n_links + ", each surface from what those before it had just got";
        break;
    case GatherOrder::southwell: {
        const Shots shots = shoot(setting, state, renewed, cancel);
        work.link_evaluations = shots.links;
        state.sentence = std::to_string(shots.surfaces) + " times the surface with the most unshot light shot it, over " +
                         std::to_string(shots.links) + " of " + n_links;
        break;
    }
    }
    const std::int64_t coefficients =
        state.counters.links > 0 ? state.counters.link_coefficients * work.link_evaluations / state.counters.links : 0;
    const int n_solved = setting.plan.channels.n_solved();
    work.products = n_solved * coefficients;
    if (setting.options.effects[Effect::colour] == Switch::automatic)
        work.spared[Effect::colour] = (3 - n_solved) * coefficients;
    state.counters.work += work;
    state.counters.total_work += work;
    state.counters.link_bytes = link_bytes(state.interactions, state.batches);
}

} // namespace penumbra
