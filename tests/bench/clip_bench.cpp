// The exact visible part of a source from a point: clips a second (a source clipped by the cone of one blocker).
#include "scene/build_scene.h"
#include "visibility/visible_part.h"

#include <benchmark/benchmark.h>

namespace penumbra {

namespace {

RawFace rectangle(double z, double x0, double x1, double y0, double y1) {
    return {"", "", 0, false, {Vec3(x0, y0, z), Vec3(x1, y0, z), Vec3(x1, y1, z), Vec3(x0, y1, z)}};
}

/// A floor, a light that faces it, and n slats between them at different heights, each of which hides a strip of the
/// light from the floor's centre.
Scene fence(int n) {
    RawScene raw;
    raw.materials.emplace_back();
    raw.faces.push_back(rectangle(0, -2, 2, -2, 2));
    raw.faces.push_back(rectangle(2, -0.5, 0.5, -0.5, 0.5));
    std::swap(raw.faces.back().corners[1], raw.faces.back().corners[3]);
    for (int i = 0; i < n; ++i) {
        const double middle = -0.225 + 0.45 * (i + 0.5) / n, half = 0.1 / n;
        raw.faces.push_back(rectangle(0.9 + 0.2 * (i % 2) / n, middle - half, middle + half, -0.2, 0.15));
    }
    return build_scene(std::move(raw));
}

void clips(benchmark::State &state) {
    const Scene scene = fence(static_cast<int>(state.range(0)));
    const Blockers blockers(scene);
    const Surface &floor = scene.surfaces[0], &light = scene.surfaces[1];
    std::vector<PairBlocker> pair;
    for (std::size_t b = 2; b < blockers.all().size(); ++b)
        pair.push_back({static_cast<int>(b), false});
    ConvexPieces whole;
    whole.add(light.outline);
    const Vec3 x = floor.frame.to_space(centroid(floor.outline));
    VisibleScratch scratch;
    Work work;
    for (auto _ : state) {
        scratch.hidden.cast(x, light.frame, blockers, pair, work);
        visible_part(x, floor.frame.normal, light.frame, whole, scratch.hidden, scratch);
        benchmark::DoNotOptimize(scratch.pieces);
    }
    if (scratch.pieces.area() > 0.95 * light.area)
        state.SkipWithError("the slats hide nothing");
    state.SetItemsProcessed(state.iterations());
    state.counters["clips"] = benchmark::Counter(static_cast<double>(work.clips), benchmark::Counter::kIsRate);
    state.counters["pieces"] = static_cast<double>(scratch.pieces.size());
}
BENCHMARK(clips)->ArgName("blockers")->Arg(1)->Arg(17);

} // namespace

} // namespace penumbra
