// Moments of a source element at a receiver point: kernel evaluations and points a second.
#include "transport/source_moments.h"

#include <benchmark/benchmark.h>

#include <array>

namespace penumbra {

namespace {

/// A unit square at z = 0.3 that faces down, with one side on the wall x = 0.
struct Pair {
    PlaneFrame source;
    ElementBasis basis;
    ConvexPieces whole;

    explicit Pair(int order)
        : source{Vec3(0, 0, 0.3), Vec3::UnitY(), Vec3::UnitX(), -Vec3::UnitZ()},
          basis(order, BilinearQuad{{Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)}}) {
        whole.add(basis.outline());
    }
};

void run(benchmark::State &state, int order, const Vec3 &x, const Vec3 &n, double accuracy) {
    const Pair pair(order);
    std::array<double, max_functions> moments;
    const std::span<double> wanted(moments.data(), static_cast<std::size_t>(order * order));
    Work work;
    for (auto _ : state) {
        source_moments(x, n, pair.source, pair.basis, pair.whole, accuracy, wanted, work);
        benchmark::DoNotOptimize(moments);
    }
    state.SetItemsProcessed(state.iterations());
    state.counters["kernel_evaluations"] =
        benchmark::Counter(static_cast<double>(work.kernel_evaluations), benchmark::Counter::kIsRate);
    state.counters["evaluations_a_point"] =
        benchmark::Counter(static_cast<double>(work.kernel_evaluations), benchmark::Counter::kAvgIterations);
}

// The closed form alone: a constant emitter has no other moment.
void moments_lambert(benchmark::State &state) { run(state, 1, Vec3(0.4, 0.3, -2), Vec3::UnitZ(), 1e-3); }

// Gauss rules, at three times the source's radius.
void moments_far(benchmark::State &state) {
    run(state, static_cast<int>(state.range(0)), Vec3(0.4, 0.3, -2), Vec3::UnitZ(), 1e-3);
}

// Graded panels: the point lies on a wall that the source touches, this far below the common edge.
void moments_near(benchmark::State &state) {
    const double below = 0.1 / static_cast<double>(state.range(1));
    run(state, static_cast<int>(state.range(0)), Vec3(0, 0.3, 0.3 - below), Vec3::UnitX(), 1e-3);
}

BENCHMARK(moments_lambert);
BENCHMARK(moments_far)->ArgName("order")->Arg(2)->Arg(4);
BENCHMARK(moments_near)->ArgNames({"order", "tenths_over_distance"})->Args({2, 1})->Args({4, 1})->Args({4, 1000});

} // namespace

} // namespace penumbra
