// The discontinuity curves of all emitters, and how their cost grows with the number of polygons.
#include "solved.h"

#include "discontinuity/arrangement.h"
#include "discontinuity/trace_curves.h"
#include "office/office.h"
#include "scene/read_obj.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <map>
#include <string>

namespace penumbra {

namespace {

Scene office_scene(int n_polygons) {
    const SceneText text = office(n_polygons);
    return read_obj_text("office.obj", text.obj, [&](const std::string &) { return std::optional(text.mtl); });
}

void count(benchmark::State &state, const Scene &scene, std::size_t n_curves) {
    state.counters["polygons"] = scene.n_surfaces();
    state.counters["curves"] = static_cast<double>(n_curves);
    state.counters["s_per_1000_curves"] =
        benchmark::Counter(static_cast<double>(n_curves) / 1000,
                           benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void curves_of(benchmark::State &state, const Scene &scene) {
    std::size_t n = 0;
    for (auto _ : state)
        n = trace_emitter_curves(scene).size();
    count(state, scene, n);
}

void curves(benchmark::State &state, const char *name) { curves_of(state, open_scene(name)); }
void office_curves(benchmark::State &state, int n_polygons) { curves_of(state, office_scene(n_polygons)); }

/// Processor time of all threads, and wall time.
void both_times(benchmark::internal::Benchmark *b) {
    b->MeasureProcessCPUTime()->UseRealTime()->Unit(benchmark::kMillisecond);
}

constexpr std::array<int, 5> office_sizes{75, 150, 300, 600, 1200};

/// The slope of the straight line that fits log y against log x best (least squares): the exponent of the growth.
template <std::size_t n>
double growth(const std::array<double, n> &x, const std::array<double, n> &y) {
    double mean_x = 0, mean_y = 0, xx = 0, xy = 0;
    for (std::size_t i = 0; i < n; ++i) {
        mean_x += std::log(x[i]) / n;
        mean_y += std::log(y[i]) / n;
    }
    for (std::size_t i = 0; i < n; ++i) {
        const double dx = std::log(x[i]) - mean_x;
        xx += dx * dx;
        xy += dx * (std::log(y[i]) - mean_y);
    }
    return xy / xx;
}

/// Offices of all sizes one after the other; exponents of processor time by polygons and by real curves.
void growth_of_curves(benchmark::State &state) {
    std::array<double, office_sizes.size()> polygons, n_curves, seconds;
    for (auto _ : state)
        for (std::size_t i = 0; i < office_sizes.size(); ++i) {
            const Scene scene = office_scene(office_sizes[i]);
            const std::clock_t start = std::clock();
            n_curves[i] = static_cast<double>(trace_emitter_curves(scene).size());
            seconds[i] = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
            polygons[i] = scene.n_surfaces();
        }
    state.counters["exponent_by_polygons"] = growth(polygons, seconds);
    state.counters["exponent_by_curves"] = growth(n_curves, seconds);
}

/// The regions of the receiver with the most curves.
void arrangement(benchmark::State &state, const char *name) {
    const Scene scene = open_scene(name);
    std::map<int, std::vector<Curve>> by_receiver;
    for (const Curve &c : trace_emitter_curves(scene))
        by_receiver[c.receiver.index].push_back(c);
    const auto most = std::ranges::max_element(by_receiver, {}, [](const auto &r) { return r.second.size(); });
    std::size_t n_regions = 0;
    for (auto _ : state)
        n_regions = arrange(scene.surface(SurfaceId(most->first)), most->second).faces.size();
    state.counters["curves"] = static_cast<double>(most->second.size());
    state.counters["regions"] = static_cast<double>(n_regions);
}

const bool registered = [] {
    for (const char *scene : {"cornell-box", "office"})
        benchmark::RegisterBenchmark(("curves/" + std::string(scene)).c_str(), curves, scene)->Apply(both_times);
    for (const int n : office_sizes)
        benchmark::RegisterBenchmark(("curves/office-of/" + std::to_string(n)).c_str(), office_curves, n)
            ->Apply(both_times);
    benchmark::RegisterBenchmark("curves/growth", growth_of_curves)->Iterations(1)->Apply(both_times);
    for (const char *scene : {"cornell-box", "three-blockers"})
        benchmark::RegisterBenchmark(("arrangement/" + std::string(scene)).c_str(), arrangement, scene)
            ->Unit(benchmark::kMillisecond);
    return true;
}();

} // namespace

} // namespace penumbra
