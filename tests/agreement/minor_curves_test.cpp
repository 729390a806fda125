// Curves that are not worth a cut: without them the answer is the same to less than the threshold.
#include "iteration/solver.h"
#include "reference/solution.h"
#include "scene/bundled.h"

#include <gtest/gtest.h>

namespace penumbra {
namespace {

struct Case {
    const char *scene;
    double threshold;
};

class MinorCurves : public testing::TestWithParam<Case> {};

TEST_P(MinorCurves, LeavingThemOutChangesTheAnswerByLessThanTheThreshold) {
    const auto scene = std::make_shared<const Scene>(open_scene(GetParam().scene));
    Options options;
    options.threshold = GetParam().threshold;
    Solver some(scene, options);
    some.run();
    options.least_gain = 0;
    Solver all(scene, options);
    all.run();
    EXPECT_GT(some.counters().total_work.left_out_curves, all.counters().total_work.left_out_curves);
    const double peak = all.snapshot()->peak;
    EXPECT_LT(reference::root_mean_square_difference(*scene, *some.state(), *all.state()), options.threshold * peak);
    // And it takes hardly more patches to do without.
    EXPECT_LE(some.counters().patches, 1.05 * all.counters().patches);
}

INSTANTIATE_TEST_SUITE_P(Scenes, MinorCurves,
                         testing::Values(Case{"skew-blockers", 0.02}, Case{"skew-blockers", 0.005},
                                         Case{"box-on-floor", 0.02}, Case{"stairs", 0.02}, Case{"cornell-box", 0.01}));

} // namespace
} // namespace penumbra
