// The reference gathers a converged solution anew: against closed forms, and against rays.
#include "iteration/solver.h"
#include "iteration/state.h"
#include "measure/reference.h"
#include "scene/bundled.h"

#include <gtest/gtest.h>

#include <memory>

namespace penumbra {

namespace {

std::shared_ptr<const Scene> scene_of(const char *name) { return std::make_shared<const Scene>(open_scene(name, {})); }

Reference reference_of(const std::shared_ptr<const Scene> &scene, const State &state) {
    return {scene, {std::make_shared<const Forest>(state.forest), state.radiosity}};
}

TEST(References, OfAFurnaceIsTheClosedForm) {
    // E = 1, rho = 0.5 and B_h = 1.875 all round: a gather makes 1 + 0.5 * 1.875 of it.
    const auto scene = scene_of("furnace");
    const auto forest = std::make_shared<const Forest>(plant(*scene, 4));
    Coefficients radiosity = Coefficients::Zero(forest->n_coefficients, 3);
    for (const Element &e : forest->elements)
        radiosity.row(e.first).setConstant(1.875);
    const Reference reference(scene, {forest, radiosity});
    for (int s = 0; s < scene->n_surfaces(); ++s)
        for (const double t : {0.03, 0.5, 0.9}) {
            const Surface &surface = scene->surface(SurfaceId(s));
            const Vec2 at = (1 - t) * surface.outline[0] + t * (0.3 * surface.outline[1] + 0.7 * surface.outline[2]);
            EXPECT_NEAR(reference.radiosity_at(SurfaceId(s), at).maxCoeff(), 1.9375, 2e-6) << s;
        }
}

class ReferencesOf : public testing::TestWithParam<const char *> {};

TEST_P(ReferencesOf, AgreeWithRays) {
    // Rays see the same reflected light by no code that the gather uses. Their two gathers a point tell their noise: in the
    // mean of both against the reference, no more than that noise and a share of chance may be seen.
    const auto scene = scene_of(GetParam());
    Solver solver(scene, Options().to_tolerance(0.05));
    ASSERT_TRUE(solver.run());
    const auto state = solver.state();
    const Blockers blockers(*scene);
    const RayScene rays(*scene);
    ResidualSampling sampling;
    sampling.n_strata = 64;
    sampling.n_points = 16;
    sampling.seed = 3;
    Work work;
    const Field field{state->forest, state->radiosity};
    const Solution solution{*scene, blockers, &rays, state->forest, state->radiosity};
    const Reference reference = reference_of(scene, *state);
    double noise = 0, difference = 0, reflected = 0;
    for (const auto &batch : sample_residual(solution, field, sampling, nullptr, work))
        for (const ResidualPoint &p : batch) {
            const Rgb r = reference.radiosity_at(p.surface, p.at) - scene->exitance(p.surface) - p.solution;
            noise += p.area * (0.5 * (p.first - p.second)).square().sum();
            difference += p.area * (0.5 * (p.first + p.second) - r).square().sum();
            reflected += p.area * (p.solution + r).square().sum();
        }
    EXPECT_GT(noise, 0);
    EXPECT_LT(noise, 1e-5 * reflected);
    EXPECT_LT(difference, 2 * noise + 1e-8 * reflected);
}

INSTANTIATE_TEST_SUITE_P(Scenes, ReferencesOf, testing::Values("cornell-box", "stairs", "next-room", "table"));

TEST(References, WhereLightBouncesOnceErrorsAreThoseOfTheExactDirectSolution) {
    // On a grid (measure/direct.h), and here at random points.
    const auto scene = scene_of("slanted-edge");
    ASSERT_TRUE(has_one_bounce(*scene));
    Solver solver(scene, Options());
    ASSERT_TRUE(solver.run());
    const auto state = solver.state();
    const double error = error_against(Reference(scene), *scene, {state->forest, state->radiosity}, 4096);
    EXPECT_NEAR(error, solver.snapshot(true)->error, 0.1 * error);
}

} // namespace

} // namespace penumbra
