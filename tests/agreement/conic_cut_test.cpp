// Arcs of conics are cut by chords: what is lost between chord and arc stays below the oracle's threshold.
#include "iteration/solver.h"
#include "iteration/state.h"
#include "measure/direct.h"
#include "reference/solution.h"
#include "scene/bundled.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace penumbra {
namespace {

class ConicCuts : public testing::TestWithParam<double> {};

TEST_P(ConicCuts, TheErrorOnAndBesideArcsIsBelowTheThreshold) {
    const double threshold = GetParam();
    const auto scene = std::make_shared<const Scene>(open_scene("skew-blockers"));
    const Blockers blockers(*scene);
    Options options;
    options.threshold = threshold;
    Solver solver(scene, options);
    ASSERT_TRUE(solver.run());
    const auto state = solver.state();
    const double peak = state->peak;
    int n_points = 0, n_above = 0;
    double squares = 0;
    for (const Curve &arc : state->curves->curves()) {
        if (arc.straight())
            continue;
        const Vec2 chord = (arc.to - arc.from).normalized(), across(-chord.y(), chord.x());
        const double sagitta = std::abs((point_at(arc, 0.5) - arc.from).dot(across));
        for (int k = 1; k < 24; ++k)
            for (const double offset : {-0.5, 0.0, 0.5}) {
                const Vec2 p = point_at(arc, k / 24.0) + offset * sagitta * across;
                if (!contains(scene->surface(arc.receiver).outline, p))
                    continue;
                const Rgb exact = direct_radiosity(*scene, blockers, arc.receiver, p);
                const double off = (reference::radiosity_at(*state, arc.receiver, p) - exact).abs().maxCoeff() / peak;
                n_above += off > threshold;
                squares += off * off;
                ++n_points;
            }
    }
    EXPECT_GT(n_points, 500);
    EXPECT_LT(std::sqrt(squares / n_points), threshold) << "root mean square, of the peak";
    // The oracle looks at points of an element, not at all: the rest are in the corners of leaves, where a polynomial
    // is farthest from what it fits.
    EXPECT_LE(n_above, 0.03 * n_points);
}

INSTANTIATE_TEST_SUITE_P(Thresholds, ConicCuts, testing::Values(0.05, 0.02, 0.01, 0.005, 0.002, 0.001));

} // namespace
} // namespace penumbra
