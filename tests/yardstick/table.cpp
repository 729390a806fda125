// yardstick SCENE [SURFACE]: patches against relative L2 error on one surface (0), of the best quadtree of bicubic
// patches and of the solver's strategies at several thresholds and depths.
#include "yardstick/best_quadtree.h"

#include "iteration/solver.h"
#include "iteration/state.h"
#include "scene/bundled.h"

#include <cstdio>
#include <cstdlib>
#include <iterator>

using namespace penumbra;

int main(int argc, char **argv) {
    const auto scene = std::make_shared<const Scene>(open_scene(argc > 1 ? argv[1] : "box-on-floor"));
    const SurfaceId surface(argc > 2 ? std::atoi(argv[2]) : 0);
    const yardstick::ExactLight exact(*scene, surface);
    const Forest bare = plant(*scene, 4);
    const auto best = yardstick::best_quadtree(exact, bare[bare.roots[surface.at()].front()].basis.quad(), 4, 1e-3);
    std::puts("best quadtree: patches, error");
    for (std::size_t i = 0, step = 1; i < best.size(); i += step, step = i / 4 + 1)
        std::printf("%8d  %.6f\n", best[i].patches, best[i].error);
    std::printf("%8d  %.6f\n", best.back().patches, best.back().error);

    std::puts("strategy, max_depth, threshold, patches, error, best quadtree's patches, its share, seconds");
    for (const Strategy strategy : {Strategy::uniform_wavelet, Strategy::discontinuity_wavelet})
        for (const int depth : {4, 6, 8, 10})
            for (const double threshold : {0.05, 0.02, 0.01, 0.005, 0.002, 0.001}) {
                Options options;
                options.strategy = strategy;
                options.threshold = threshold;
                options.max_depth = depth;
                Solver solver(scene, options);
                solver.run();
                int patches = 0;
                const auto state = solver.state();
                for (const ElementId root : state->forest.roots[surface.at()])
                    for_each_leaf(state->forest, root, [&](ElementId) { ++patches; });
                const double error =
                    yardstick::relative_error(exact, state->forest, state->radiosity, scene->exitance(surface));
                const int yard = yardstick::patches_for(best, error);
                std::printf("%s %2d %.3f %6d %.6f %6d %.3f %.2f\n", std::string(name(strategy)).c_str(), depth,
                            threshold, patches, error, yard, yard ? double(patches) / yard : 0.0,
                            solver.counters().seconds);
                std::fflush(stdout);
            }
}
