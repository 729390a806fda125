// From Cancel raised to the solver stopped.
#include "solved.h"

#include "iteration/state.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <random>
#include <thread>

namespace penumbra {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// Processor seconds of all threads of this process.
double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// States of a run, and how long the step after each took.
struct Run {
    std::vector<std::shared_ptr<const State>> before;
    std::vector<double> seconds;
};

Run run_of(Solver &solver, int n_steps) {
    Run run;
    while (static_cast<int>(run.before.size()) < n_steps && !solver.converged()) {
        const auto start = Clock::now();
        run.before.push_back(solver.state());
        solver.step();
        run.seconds.push_back(seconds_since(start));
    }
    return run;
}

// Each try steps from a random state of a run on cornell-box and raises the flag at a random moment of that step. The
// time is the wait; `max_ms` is the longest, which must stay under 100. Where other programs hold the cores, the wait
// has their time in it: `max_cpu_ms` is what this process still worked. A try whose step ended first counts as missed.
void cancel_cornell_box(benchmark::State &state, Strategy strategy) {
    Solver solver(bundled("cornell-box"), options_of(strategy, 0.02));
    const Run run = run_of(solver, 10);
    std::mt19937 random(1995);
    double longest = 0, longest_work = 0;
    int missed = 0;
    for (auto _ : state) {
        const std::size_t at = std::uniform_int_distribution<std::size_t>(0, run.before.size() - 1)(random);
        const double moment = std::uniform_real_distribution<double>(0, run.seconds[at])(random);
        solver.restore(run.before[at]);
        Cancel cancel;
        bool stopped = false;
        std::jthread worker([&] {
            try {
                solver.step(&cancel);
            } catch (const Cancelled &) {
                stopped = true;
            }
        });
        std::this_thread::sleep_for(std::chrono::duration<double>(moment));
        const auto raised = Clock::now();
        const double work = cpu_seconds();
        cancel.raise();
        worker.join();
        const double wait = seconds_since(raised);
        state.SetIterationTime(wait);
        missed += !stopped;
        longest = std::max(longest, wait);
        longest_work = std::max(longest_work, cpu_seconds() - work);
        if (stopped && solver.state() != run.before[at]) {
            state.SkipWithError("the solver does not stand where it stood");
            return;
        }
    }
    state.counters["max_ms"] = 1e3 * longest;
    state.counters["max_cpu_ms"] = 1e3 * longest_work;
    state.counters["missed"] = missed;
}
BENCHMARK_CAPTURE(cancel_cornell_box, uniform_wavelet, Strategy::uniform_wavelet)
    ->UseManualTime()
    ->Iterations(200)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(cancel_cornell_box, discontinuity_wavelet, Strategy::discontinuity_wavelet)
    ->UseManualTime()
    ->Iterations(200)
    ->Unit(benchmark::kMillisecond);

} // namespace

} // namespace penumbra
