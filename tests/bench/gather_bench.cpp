// The gather: its phase as it comes, and one pass over links that no cache holds, against the machine's copying.
#include "solved.h"

#include "core/parallel.h"
#include "iteration/state.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cstring>

namespace penumbra {

namespace {

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
    state.counters["links"] = static_cast<double>(refined->counters.links);
}
BENCHMARK_CAPTURE(gather_cornell_box, uniform_constant, Strategy::uniform_constant)->UseManualTime()->MinTime(0.2);
BENCHMARK_CAPTURE(gather_cornell_box, uniform_wavelet, Strategy::uniform_wavelet)->UseManualTime()->MinTime(0.2);
BENCHMARK_CAPTURE(gather_cornell_box, discontinuity_wavelet, Strategy::discontinuity_wavelet)
    ->UseManualTime()
    ->MinTime(0.2);

double last_level_cache() {
    int size = 0;
    for (const auto &cache : benchmark::CPUInfo::Get().caches)
        size = std::max(size, cache.size);
    return size;
}

double seconds_of(const auto &work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Memory from end to end in blocks of a MiB, by all threads.
void copy(const std::vector<std::uint64_t> &from, std::vector<std::uint64_t> &to) {
    constexpr std::size_t block = 1 << 17;
    parallel_for(from.size() / block, [&](std::size_t i) {
        std::memcpy(to.data() + i * block, from.data() + i * block, block * sizeof(from[0]));
    });
}

/// The links of a solution, each receiver's so many times over that all batches exceed four times the last-level cache. By
/// turns with a copy of as many bytes, half read and half written; `share`: bytes of links a second, to bytes copied.
void gather_beyond_cache(benchmark::State &state, Strategy strategy, BasisFamily basis) {
    Options options = options_of(strategy, 0.02);
    options.basis = basis;
    options.threads = static_cast<int>(state.range(0));
    Solver solver(bundled("cornell-box"), options);
    for (int i = 0; i < 8; ++i)
        solver.step();
    State links = *solver.state();
    const auto bytes = [&] {
        double sum = 0;
        for (const auto &batch : links.batches)
            sum += batch ? static_cast<double>(batch->bytes()) : 0;
        return sum;
    };
    const auto times = static_cast<std::size_t>(4.1 * last_level_cache() / bytes()) + 1;
    for (auto &here : links.interactions) {
        const auto once = here;
        for (std::size_t i = 1; i < times; ++i)
            here.insert(here.end(), once.begin(), once.end());
    }
    renew(links.batches, links.forest, links.interactions, {}, nullptr);
    const double read = bytes();
    std::vector<std::uint64_t> from(static_cast<std::size_t>(read / 2 / sizeof(std::uint64_t)), 1), to(from.size(), 2);
    copy(from, to);
    double gather_s = 0, copy_s = 0;
    for (auto _ : state) {
        const double s = seconds_of([&] { benchmark::DoNotOptimize(gathered(links, links.radiosity, nullptr)); });
        state.SetIterationTime(s);
        gather_s += s;
        copy_s += seconds_of([&] { copy(from, to); });
    }
    const auto n = static_cast<double>(state.iterations());
    state.counters["caches"] = read / last_level_cache();
    state.counters["gather_GB_s"] = 1e-9 * read * n / gather_s;
    state.counters["copy_GB_s"] = 1e-9 * read * n / copy_s;
    state.counters["share"] = copy_s / gather_s;
}
BENCHMARK_CAPTURE(gather_beyond_cache, uniform_constant, Strategy::uniform_constant, BasisFamily::parametric)
    ->Arg(1)->Arg(2)->UseManualTime()->MinTime(2);
BENCHMARK_CAPTURE(gather_beyond_cache, uniform_wavelet, Strategy::uniform_wavelet, BasisFamily::parametric)
    ->Arg(1)->Arg(2)->UseManualTime()->MinTime(2);
BENCHMARK_CAPTURE(gather_beyond_cache, discontinuity_wavelet, Strategy::discontinuity_wavelet, BasisFamily::parametric)
    ->Arg(1)->Arg(2)->UseManualTime()->MinTime(2);
BENCHMARK_CAPTURE(gather_beyond_cache, planar, Strategy::discontinuity_wavelet, BasisFamily::planar)
    ->Arg(1)->Arg(2)->UseManualTime()->MinTime(2);

} // namespace

} // namespace penumbra
