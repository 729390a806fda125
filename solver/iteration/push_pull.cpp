#include "core/percent.h"
#include "iteration/coarse_correction.h"
#include "iteration/state.h"

#include <algorithm>
#include <string>

namespace penumbra {

namespace {

/// Largest B - E over the corners and the centre of the leaves, and the largest change of B there.
struct Extremes {
    double reflected = 0, change = 0;
};

Extremes extremes(const State &state, const Scene &scene, const Coefficients &before) {
    Extremes most;
    for (const Element &e : state.forest.elements) {
        if (!e.leaf() || !scene.reflects(e.surface))
            continue;
        const int n = e.basis.n_functions();
        const auto now = state.radiosity.middleRows(e.first, n), then = before.middleRows(e.first, n);
        std::vector<Vec2> points = e.basis.outline();
        points.push_back(e.basis.centre());
        for (const Vec2 &p : points) {
            const BasisValues value = e.basis.evaluate(p);
            const Rgb b = (value.transpose() * now).transpose().array();
            const Rgb d = (value.transpose() * (now - then)).transpose().array();
            most.reflected = std::max(most.reflected, (b - scene.exitance(e.surface)).maxCoeff());
            most.change = std::max(most.change, d.abs().maxCoeff());
        }
    }
    return most;
}

} // namespace

void push_pull(const Setting &setting, State &state) {
    const Scene &scene = *setting.scene;
    // Of what light has been gathered already: the rest is still to come.
    const Coefficients before = setting.options.gather == GatherOrder::southwell ? state.shot : state.radiosity;
    push_pull(state.forest, scene, state.irradiance, state.radiosity);
    const bool corrects = corrects_coarsely(setting);
    if (corrects)
        correct_coarsely(setting, state, before);
    const Extremes most = extremes(state, scene, before);
    state.peak = most.reflected;
    Counters &c = state.counters;
    c.change = most.reflected > 0 ? most.change / most.reflected : 0;
    if (!state.radiosity.allFinite()) { // a fault of the solver's: nothing that follows is worth anything
        c.settled = false;
        c.exhausted = true;
        state.sentence = "radiosity is not finite: the solution is void";
        return;
    }
    c.settled = !c.refined && c.change <= 0.1 * c.threshold * (1 - setting.largest_reflectance());
    state.sentence = c.settled ? "converged: nothing refined, and radiosity no longer changes"
                               : "pushed irradiance to " + std::to_string(c.patches) +
                                       " patches and pulled radiosity up; it changed by " + percent(c.change);
    if (corrects && !c.settled)
        state.sentence += "; a constant on each surface took the bounces to come ahead";
}

} // namespace penumbra
