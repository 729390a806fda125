// The quadratic reconstruction of constant solutions, against the exact direct light.
#include "iteration/quadratic.h"
#include "iteration/solver.h"
#include "measure/direct.h"
#include "scene/bundled.h"
#include "unit/obj_text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

namespace penumbra {

namespace {

struct Errors {
    double constant = 0, quadratic = 0;
};

Errors errors_of(const std::shared_ptr<const Scene> &scene, const Options &options) {
    Solver solver(scene, options);
    EXPECT_TRUE(solver.run());
    const Setting setting{scene, options, std::make_unique<const Blockers>(*scene)};
    const auto state = solver.state();
    const QuadraticField field = reconstruct(setting, *state, nullptr);
    return {direct_error(*scene, *setting.blockers, state->forest, state->radiosity),
            direct_error(*scene, *setting.blockers, field.forest, field.radiosity)};
}

class Quadratics : public testing::TestWithParam<BasisFamily> {};

TEST_P(Quadratics, IsOfThirdOrderWhereNothingCastsShadows) {
    // Halving h takes the constants' error to a half, that of quadratics through exact values to an eighth.
    const auto scene = std::make_shared<const Scene>(
        scene_of("mtllib m\nv -2 -2 0\nv 2 -2 0\nv 2 2 0\nv -2 2 0\nv -0.5 -0.5 2\nv 0.5 -0.5 2\nv 0.5 0.5 2\nv -0.5 0.5 2\n"
                 "usemtl grey\nf 1 2 3 4\nusemtl lamp\nf 8 7 6 5\n",
                 "newmtl grey\nKd 0.5 0.5 0.5\nnewmtl lamp\nKd 0 0 0\nKe 1 1 1\n"));
    Options options;
    options.strategy = Strategy::uniform_constant;
    options.basis = GetParam();
    options.threshold = 1e-9;
    options.max_depth = 3;
    const Errors coarse = errors_of(scene, options);
    options.max_depth = 4;
    const Errors fine = errors_of(scene, options);
    EXPECT_NEAR(coarse.constant / fine.constant, 2, 0.1);
    EXPECT_GT(coarse.quadratic / fine.quadratic, 7);
    EXPECT_LT(fine.quadratic, 0.01 * fine.constant);
}

TEST_P(Quadratics, KeepsTheEdgesThatElementsWereCutAlong) {
    // Cut along the shadow's edges each piece is smooth; uniform elements that a shadow's edge crosses are not.
    const auto scene = std::make_shared<const Scene>(open_scene("slanted-edge", {}));
    Options options;
    options.basis = GetParam();
    options.threshold = 0.03;
    options.strategy = Strategy::discontinuity_constant;
    const Errors cut = errors_of(scene, options);
    options.strategy = Strategy::uniform_constant;
    const Errors uniform = errors_of(scene, options);
    EXPECT_LT(cut.quadratic, 0.25 * cut.constant);
    EXPECT_LT(uniform.quadratic, 0.5 * uniform.constant);
}

INSTANTIATE_TEST_SUITE_P(Bases, Quadratics, testing::Values(BasisFamily::parametric, BasisFamily::planar),
                         [](const auto &at) { return std::string(name(at.param)); });

} // namespace

} // namespace penumbra
