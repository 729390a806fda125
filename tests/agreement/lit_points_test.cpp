// The oracle looks where a small source lights a large element.
#include "iteration/solver.h"
#include "iteration/state.h"
#include "measure/reference.h"
#include "scene/bundled.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

namespace penumbra {

namespace {

TEST(LitPoints, WhatARiserBringsToTheFloorBeforeItIsNotPassedOver) {
    // The first riser of the stairs lights a strip of the floor as wide as it is high, a tenth of the floor's side: a grid of
    // test points over the floor sees nothing of it. Against a gather of the same solution: sources pass one by one, so
    // that twice the threshold is allowed.
    const auto scene = std::make_shared<const Scene>(open_scene("stairs", {}));
    Options options;
    options.threshold = 0.02;
    Solver solver(scene, options);
    ASSERT_TRUE(solver.run());
    const auto state = solver.state();
    const Reference reference(scene, {std::make_shared<const Forest>(state->forest), state->radiosity});
    ResidualSampling sampling;
    sampling.n_batches = 1;
    sampling.n_points = 2000;
    int n = 0;
    double worst = 0;
    const auto batches = draw_points(*scene, {state->forest, state->radiosity}, sampling);
    for (const ResidualPoint &p : batches.front())
        if (scene->surface(p.surface).name == "floor") {
            const Rgb residual = reference.radiosity_at(p.surface, p.at) - scene->exitance(p.surface) - p.solution;
            worst = std::max(worst, residual.abs().maxCoeff() / state->peak);
            ++n;
        }
    EXPECT_GT(n, 500);
    EXPECT_LT(worst, 2 * options.threshold);
}

} // namespace

} // namespace penumbra
