// What a moving mouse costs the drawing thread: looking through the keyhole, and finding the curve under the cursor.
#include "solved.h"

#include "measure/keyhole.h"
#include "render/pick_curve.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <vector>

namespace penumbra {

namespace {

/// Centres of the reflecting surfaces, in the scene's own frame.
std::vector<std::pair<SurfaceId, Vec3>> places(const Scene &scene) {
    std::vector<std::pair<SurfaceId, Vec3>> all;
    for (int s = 0; s < scene.n_surfaces(); ++s)
        if (scene.reflects(SurfaceId(s))) {
            const Surface &surface = scene.surface(SurfaceId(s));
            all.emplace_back(s, scene.own.to_own(surface.frame.to_space(centroid(surface.parts[0]))));
        }
    return all;
}

void looks(benchmark::State &state, const char *name) {
    const auto scene = bundled(name);
    const KeyholeEye eye(scene);
    const auto from = places(*scene);
    std::size_t i = 0;
    double longest = 0;
    for (auto _ : state) {
        const auto start = std::chrono::steady_clock::now();
        benchmark::DoNotOptimize(eye.look(from[i].first, from[i].second));
        longest = std::max(longest, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
        i = (i + 1) % from.size();
    }
    state.counters["longest_ms"] = 1e3 * longest;
}

void opens(benchmark::State &state, const char *name) {
    const auto scene = bundled(name);
    for (auto _ : state)
        benchmark::DoNotOptimize(KeyholeEye(scene));
}

void picks(benchmark::State &state, const char *name) {
    const auto scene = bundled(name);
    const auto snapshot = Solver(scene, Options{}).snapshot();
    const Camera camera = first_view(*scene, *snapshot, 1.6);
    int i = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(
            pick_curve(*snapshot, camera, 1.6, -0.8 + 0.1 * (i % 17), -0.8 + 0.1 * (i / 17 % 17), 700, 6));
        ++i;
    }
    state.counters["curves"] = static_cast<double>(snapshot->curves->size());
}

const bool registered = [] {
    for (const char *scene : {"skew-blockers", "cornell-box", "venetian-blinds", "office"}) {
        const std::string of = "/" + std::string(scene);
        benchmark::RegisterBenchmark(("keyhole/look" + of).c_str(), [=](benchmark::State &s) {
            looks(s, scene);
        })->Unit(benchmark::kMillisecond);
        benchmark::RegisterBenchmark(("keyhole/open" + of).c_str(), [=](benchmark::State &s) {
            opens(s, scene);
        })->Unit(benchmark::kMillisecond);
        benchmark::RegisterBenchmark(("pick_curve" + of).c_str(), [=](benchmark::State &s) {
            picks(s, scene);
        })->Unit(benchmark::kMillisecond);
    }
    return true;
}();

} // namespace

} // namespace penumbra
