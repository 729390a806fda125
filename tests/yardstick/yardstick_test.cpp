// Accuracy for patches: what the solver needs beside the best quadtree of bicubic patches there can be.
#include "yardstick/best_quadtree.h"

#include "iteration/solver.h"
#include "iteration/state.h"
#include "reference/faces.h"
#include "scene/bundled.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace penumbra {
namespace {

using yardstick::best_quadtree;
using yardstick::ExactLight;
using yardstick::patches_for;
using yardstick::Standing;

constexpr SurfaceId floor_surface(0);

std::shared_ptr<const Scene> bundled(const char *name) { return std::make_shared<const Scene>(open_scene(name)); }

BilinearQuad only_root(const Scene &scene) {
    const Forest forest = plant(scene, 1);
    return forest[forest.roots[floor_surface.at()].front()].basis.quad();
}

/// What the solver needs on the floor, and how far off it is there.
Standing solved(const std::shared_ptr<const Scene> &scene, const ExactLight &exact, Strategy strategy, double threshold,
                int max_depth) {
    Options options;
    options.strategy = strategy;
    options.threshold = threshold;
    options.max_depth = max_depth;
    Solver solver(scene, options);
    EXPECT_TRUE(solver.run());
    const auto state = solver.state();
    Standing out;
    for (const ElementId root : state->forest.roots[floor_surface.at()])
        for_each_leaf(state->forest, root, [&](ElementId) { ++out.patches; });
    out.error = relative_error(exact, state->forest, state->radiosity, scene->exitance(floor_surface));
    return out;
}

TEST(Yardstick, FitsAStepAsWorkedOutByHand) {
    // A sheet on the floor's left three tenths, everything in the light of a far lamp: 0 there, and c beside it. A
    // constant over all is off by 0.3 0.7 c^2 of 0.7 c^2; quarters are right on the right, and on the left, where two
    // fifths are lit, off by 0.5 0.4 0.6 c^2.
    const auto scene =
        reference::scene_of({{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}},
                             {{{0, 0, 0}, {0.3, 0, 0}, {0.3, 1, 0}, {0, 1, 0}}, Rgb::Zero()},
                             {{{0, 0, 1000}, {0, 1, 1000}, {1, 1, 1000}, {1, 0, 1000}}, Rgb::Zero(), Rgb::Ones()}});
    const ExactLight exact(*scene, floor_surface);
    const auto standings = best_quadtree(exact, only_root(*scene), 1, 0.42);
    ASSERT_EQ(standings.size(), 2u);
    EXPECT_NEAR(standings[0].error, std::sqrt(0.3), 1e-4);
    EXPECT_EQ(standings[1].patches, 4);
    EXPECT_NEAR(standings[1].error, std::sqrt(0.12 / 0.7), 1e-4);
}

class BoxOnFloor : public testing::Test {
protected:
    static void SetUpTestSuite() {
        scene_ = bundled("box-on-floor");
        exact_ = std::make_unique<const ExactLight>(*scene_, floor_surface);
        best_ = best_quadtree(*exact_, only_root(*scene_), 4, 1e-3);
    }
    static void TearDownTestSuite() {
        exact_.reset();
        scene_.reset();
    }

    static std::shared_ptr<const Scene> scene_;
    static std::unique_ptr<const ExactLight> exact_;
    static std::vector<Standing> best_;
};
std::shared_ptr<const Scene> BoxOnFloor::scene_;
std::unique_ptr<const ExactLight> BoxOnFloor::exact_;
std::vector<Standing> BoxOnFloor::best_;

TEST_F(BoxOnFloor, TheYardstickDoesNotDependOnItsQuadrature) {
    const auto finer = best_quadtree(*exact_, only_root(*scene_), 4, 3e-3, 14);
    for (const double error : {0.1, 0.03, 0.01, 0.003}) {
        const double coarse = patches_for(best_, error), fine = patches_for(finer, error);
        EXPECT_NEAR(coarse / fine, 1, 0.02) << fine << " patches at " << error;
    }
}

TEST_F(BoxOnFloor, DiscontinuityMeshingTakesATwelfthAndAFortieth) {
    struct Case {
        double threshold, error, share;
    };
    for (const Case c : {Case{0.02, 3e-3, 1.0 / 12}, {0.005, 1e-3, 1.0 / 40}}) {
        const Standing ours = solved(scene_, *exact_, Strategy::discontinuity_wavelet, c.threshold, 6);
        EXPECT_LE(ours.error, c.error);
        EXPECT_LE(ours.patches, c.share * patches_for(best_, c.error)) << "of " << patches_for(best_, c.error);
        RecordProperty("patches_at_" + std::to_string(c.error), ours.patches);
    }
}

TEST_F(BoxOnFloor, UniformMeshingIsCloseToTheBest) {
    // A threshold that goes with the depth: with too high a one leaves are larger than the sharp edge's are worth, with
    // too low a one smaller.
    struct Case {
        int max_depth;
        double threshold;
    };
    for (const Case c : {Case{4, 0.05}, {6, 0.02}, {8, 0.02}, {10, 0.01}, {12, 0.005}, {14, 0.001}}) {
        const Standing ours = solved(scene_, *exact_, Strategy::uniform_wavelet, c.threshold, c.max_depth);
        const int best = patches_for(best_, ours.error);
        ASSERT_GT(best, 0) << ours.error;
        EXPECT_LE(ours.patches, 1.5 * best) << "depth " << c.max_depth << ", error " << ours.error;
        EXPECT_GE(ours.patches, best) << "nothing on a quadtree is better than the best";
    }
}

TEST(SkewBlockers, DiscontinuityMeshingNeedsNoMorePatchesThanUniform) {
    const auto scene = bundled("skew-blockers");
    const ExactLight exact(*scene, floor_surface);
    std::vector<Standing> runs[2];
    for (const double threshold : {0.05, 0.03, 0.02, 0.015, 0.01, 0.007, 0.005, 0.003, 0.002, 0.001}) {
        runs[0].push_back(solved(scene, exact, Strategy::uniform_wavelet, threshold, 8));
        runs[1].push_back(solved(scene, exact, Strategy::discontinuity_wavelet, threshold, 8));
    }
    runs[1].push_back(solved(scene, exact, Strategy::discontinuity_wavelet, 0.0005, 8));
    const auto fewest = [&](const std::vector<Standing> &all, double error) {
        int n = std::numeric_limits<int>::max();
        for (const Standing &s : all)
            if (s.error <= error)
                n = std::min(n, s.patches);
        return n;
    };
    // At every error that uniform meshing reached.
    for (const Standing &uniform : runs[0])
        EXPECT_LE(fewest(runs[1], uniform.error), fewest(runs[0], uniform.error)) << "at " << uniform.error;
}

} // namespace
} // namespace penumbra
