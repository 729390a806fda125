// The gather phase: bytes of link kernels read a second.
#include "solved.h"

#include "iteration/state.h"

#include <benchmark/benchmark.h>

namespace penumbra {

namespace {

double kernel_bytes(const State &state) {
    double bytes = 0;
    for (const auto &here : state.interactions)
        for (const auto &interaction : here)
            for (const Link &link : interaction->links)
                bytes += static_cast<double>(link.kernel.size()) * sizeof(double);
    return bytes;
}

// Timed by the phase's own counter: coming back to the state before it is no part of it.
void gather_cornell_box(benchmark::State &state, Strategy strategy) {
    Solver solver(bundled("cornell-box"), options_of(strategy, 0.02));
    for (int i = 0; i < 8; ++i)
        solver.step();
    solver.sub_step();
    const auto refined = solver.state();
    for (auto _ : state) {
        solver.restore(refined);
        solver.sub_step();
        state.SetIterationTime(solver.counters().gather_s);
    }
    const double bytes = kernel_bytes(*refined);
    state.SetBytesProcessed(static_cast<std::int64_t>(bytes) * state.iterations());
    state.counters["kernel_bytes"] = bytes;
    state.counters["links"] = static_cast<double>(refined->counters.links);
}
BENCHMARK_CAPTURE(gather_cornell_box, uniform_constant, Strategy::uniform_constant)->UseManualTime()->MinTime(0.2);
BENCHMARK_CAPTURE(gather_cornell_box, uniform_wavelet, Strategy::uniform_wavelet)->UseManualTime()->MinTime(0.2);
BENCHMARK_CAPTURE(gather_cornell_box, discontinuity_wavelet, Strategy::discontinuity_wavelet)
    ->UseManualTime()
    ->MinTime(0.2);

} // namespace

} // namespace penumbra
