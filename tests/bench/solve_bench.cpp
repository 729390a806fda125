// Whole solutions and their steps.
#include "solved.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <string>

namespace penumbra {

namespace {

/// One run from nothing to converged; the counters are of that run.
void solve(benchmark::State &state, const char *scene_name, Strategy strategy, double threshold) {
    const auto scene = bundled(scene_name);
    for (auto _ : state) {
        Solver solver(scene, options_of(strategy, threshold));
        double longest = 0, before = 0;
        while (!solver.converged() && solver.counters().iteration < solver.options().max_iterations) {
            solver.step();
            longest = std::max(longest, solver.counters().seconds - before);
            before = solver.counters().seconds;
        }
        const Counters &c = solver.counters();
        state.counters["steps"] = c.iteration;
        state.counters["ms_a_step"] = 1e3 * c.seconds / c.iteration;
        state.counters["ms_longest_step"] = 1e3 * longest;
        state.counters["patches"] = c.patches;
        state.counters["links"] = static_cast<double>(c.links);
        state.counters["kernel_evaluations"] = static_cast<double>(c.total_work.kernel_evaluations);
        state.counters["clips"] = static_cast<double>(c.total_work.clips);
    }
}

const bool registered = [] {
    struct Case {
        const char *scene;
        double threshold;
    };
    for (const Case c : {Case{"figure-4", 0.02}, Case{"stairs", 0.02}, Case{"cornell-box", 0.02}, Case{"cornell-box", 0.01}})
        for (const Strategy strategy : all_strategies) {
            if (is_constant(strategy) && std::string(c.scene) != "figure-4")
                continue;
            const std::string title = "solve/" + std::string(c.scene) + "/" + std::string(name(strategy)) + "/" +
                                      std::to_string(c.threshold).substr(0, 4);
            benchmark::RegisterBenchmark(title.c_str(), [=](benchmark::State &state) {
                solve(state, c.scene, strategy, c.threshold);
            })->UseRealTime()->Unit(benchmark::kMillisecond);
        }
    return true;
}();

} // namespace

} // namespace penumbra
