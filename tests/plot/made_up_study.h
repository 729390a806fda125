// A study of costs that nobody measured: four strategies in two bases, four thresholds, errors and prices on power laws,
// so that a picture of it is the same everywhere.
#pragma once

#include "files/cost_table.h"

#include <cmath>

namespace penumbra {

/// Of (a) the third threshold met the time limit of 2 s, in both bases, and the fourth was not tried; one solution of (b)
/// met its depth limit.
inline CostStudy made_up_study() {
    CostStudy study{"made-up", "A Processor", 4, 2, "1.2.3", 3, {}, {}};
    study.limits.seconds = 2;
    for (const Strategy strategy : all_strategies)
        for (const BasisFamily basis : {BasisFamily::parametric, BasisFamily::planar})
            for (int t = 0; t < 4; ++t) {
                const double rate = is_constant(strategy) ? 1 : 4, dear = basis == BasisFamily::planar ? 1.5 : 1;
                CostPoint p;
                p.options.strategy = strategy;
                p.options.basis = basis;
                p.options.order = 3;
                p.options.threshold = std::pow(10, -1 - 0.5 * t);
                p.end = RunEnd::done;
                p.error = 0.5 * p.options.threshold / (cuts_along_curves(strategy) ? 3 : 1);
                p.counters.iteration = 4;
                p.counters.patches = static_cast<int>(std::round(40 * std::pow(10, 1. * t / rate)));
                p.counters.coefficients = p.counters.patches * (is_constant(strategy) ? 1 : 9);
                p.counters.total_work.kernel_evaluations = p.counters.coefficients * 50;
                const double seconds = 0.0125 * dear * std::pow(10, 1. * t / rate);
                p.seconds = {0.8 * seconds, seconds, 1.6 * seconds};
                if (strategy == Strategy::uniform_constant && t >= 2) {
                    p.end = t == 2 ? RunEnd::time_limit : RunEnd::not_tried;
                    p.error = t == 2 ? 0.02 : -1;
                    p.seconds = t == 2 ? std::vector<double>{2.01} : std::vector<double>{};
                }
                if (strategy == Strategy::discontinuity_constant && t == 3)
                    p.counters.nodes_at_limit = 5;
                study.points.push_back(p);
            }
    return study;
}

} // namespace penumbra
