// Every bundled scene, by every strategy: finite, not darker than black by more than the oracle may miss, nothing
// sampled that should have been clipped.
#include "iteration/solver.h"
#include "iteration/state.h"
#include "scene/bundled.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <span>
#include <string>

namespace penumbra {
namespace {

Vec2 at(std::span<const Vec2> c, double u, double v) {
    return (1 - v) * ((1 - u) * c[0] + u * c[1]) + v * ((1 - u) * c[3] + u * c[2]);
}

class Bundled : public testing::TestWithParam<std::tuple<int, Strategy, BasisFamily>> {};

TEST_P(Bundled, FiniteAndNotNegative) {
    const BundledScene &bundled = bundled_scenes()[static_cast<std::size_t>(std::get<0>(GetParam()))];
    Options options;
    options.strategy = std::get<1>(GetParam());
    options.basis = std::get<2>(GetParam());
    options.threshold = 0.05;
    Solver solver(std::make_shared<const Scene>(open_scene(std::string(bundled.name))), options);
    EXPECT_TRUE(solver.run());
    const auto snapshot = solver.snapshot();
    ASSERT_EQ(snapshot->peak > 0, bundled.name != "dark");
    // Where no depth limit was met (a cubic on a jump that it may not split dips below 0), and off the covers: what lies
    // under them is dark whatever its polynomial says, and the oracle does not test it.
    double least = 0;
    int n_not_finite = 0;
    for (const SnapshotPatch &patch : snapshot->patches) {
        const auto &covers = snapshot->surfaces[static_cast<std::size_t>(patch.surface)].covers;
        const bool quad = patch.corners.size() == 4;
        for (const double u : {0.0, 0.25, 0.5, 0.75, 1.0})
            for (const double v : {0.0, 0.25, 0.5, 0.75, 1.0}) {
                // A triangle's double corner has no parameters: these points are drawn to the centre a little.
                const Vec2 p = quad ? at(patch.corners, u, v)
                                    : Vec2(0.98 * at(patch.quad, u, v) + 0.02 * centroid(patch.corners));
                if (!contains(patch.corners, p, 1e-9))
                    continue; // of a polygon, the points of its box that lie in it
                const Rgb b = radiosity(*snapshot, patch, p);
                n_not_finite += !b.isFinite().all();
                const bool covered =
                    std::ranges::any_of(covers, [&](const Polygon &cover) { return contains(cover, p); });
                least = patch.at_limit || covered ? least : std::min(least, b.minCoeff());
            }
    }
    EXPECT_EQ(n_not_finite, 0);
    // The oracle looks at points, and beyond them a misfit may be a little larger.
    EXPECT_GE(least, -1.5 * options.threshold * snapshot->peak);
    EXPECT_EQ(snapshot->counters.total_work.sampled_visibility, 0);
}

INSTANTIATE_TEST_SUITE_P(AllScenes, Bundled,
                         testing::Combine(testing::Range(0, static_cast<int>(bundled_scenes().size())),
                                          testing::ValuesIn(all_strategies),
                                          testing::Values(BasisFamily::parametric, BasisFamily::planar)),
                         [](const auto &parameters) {
                             std::string label =
                                 std::string(
                                     bundled_scenes()[static_cast<std::size_t>(std::get<0>(parameters.param))].name) +
                                 "_" + std::string(name(std::get<1>(parameters.param))) + "_" +
                                 std::string(name(std::get<2>(parameters.param)));
                             for (char &c : label)
                                 c = c == '-' ? '_' : c;
                             return label;
                         });

} // namespace
} // namespace penumbra
