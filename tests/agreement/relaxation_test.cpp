// Jacobi's, Gauss-Seidel's and Southwell's order: one fixed point, by fewer links.
#include "iteration/relaxation.h"

#include "iteration/solver.h"
#include "scene/bundled.h"

#include <gtest/gtest.h>

#include <string>

namespace penumbra {
namespace {

struct Case {
    const char *scene;
    BasisFamily basis;
};

void PrintTo(const Case &c, std::ostream *out) { *out << c.scene << ' ' << name(c.basis); }

class Relaxation : public testing::TestWithParam<Case> {
protected:
    static Options options(GatherOrder order) {
        Options options;
        options.basis = GetParam().basis;
        options.threshold = 0.05;
        options.gather = order;
        return options;
    }
    static std::shared_ptr<const Scene> scene() { return std::make_shared<const Scene>(open_scene(GetParam().scene)); }
};

/// Gathers over links that stay as they are, from dark surfaces on, until radiosity stands still.
State settled(const Setting &setting, const State &links) {
    State state = links;
    state.shot.resize(0, 3);
    state.batches.clear();
    state.irradiance.setZero();
    push_pull(state.forest, *setting.scene, state.irradiance, state.radiosity);
    for (int step = 0; step < 400; ++step) {
        gather(setting, state, nullptr);
        push_pull(setting, state);
        if (state.counters.change <= 1e-15)
            return state;
    }
    ADD_FAILURE() << "still changing by " << state.counters.change;
    return state;
}

TEST_P(Relaxation, AllOrdersComeToOneFixedPoint) {
    Solver solver(scene(), options(GatherOrder::jacobi));
    ASSERT_TRUE(solver.run());
    const auto settle = [&](GatherOrder order) {
        Setting setting{scene(), options(order)};
        setting.blockers = std::make_unique<const Blockers>(*setting.scene);
        return settled(setting, *solver.state());
    };
    const State jacobi = settle(GatherOrder::jacobi);
    const double size = jacobi.radiosity.cwiseAbs().maxCoeff();
    EXPECT_LE((jacobi.radiosity - solver.state()->radiosity).cwiseAbs().maxCoeff(), 0.05 * size);
    for (const GatherOrder order : {GatherOrder::gauss_seidel, GatherOrder::southwell}) {
        const State other = settle(order);
        EXPECT_LE((other.radiosity - jacobi.radiosity).cwiseAbs().maxCoeff(), 1e-12 * size) << name(order);
        EXPECT_LE((other.irradiance - jacobi.irradiance).cwiseAbs().maxCoeff(), 1e-12 * size) << name(order);
    }
}

// What is left to come after a sweep decides when to stop, whatever the order; the mesh may differ by a few patches.
TEST_P(Relaxation, WholeSolutionsAgree) {
    Solver jacobi(scene(), options(GatherOrder::jacobi));
    ASSERT_TRUE(jacobi.run());
    const auto mean = [](const Solver &solver) {
        const auto state = solver.state();
        double power = 0, area = 0;
        for (const auto &roots : state->forest.roots)
            for (const ElementId root : roots) {
                const Element &e = state->forest[root];
                power += e.basis.area() * state->radiosity.row(e.first).mean();
                area += e.basis.area();
            }
        return power / area;
    };
    for (const GatherOrder order : {GatherOrder::gauss_seidel, GatherOrder::southwell}) {
        Solver other(scene(), options(order));
        ASSERT_TRUE(other.run()) << name(order);
        EXPECT_NEAR(mean(other) / mean(jacobi), 1, 0.02) << name(order);
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Relaxation,
                         testing::Values(Case{"furnace", BasisFamily::parametric}, Case{"furnace", BasisFamily::planar},
                                         Case{"cornell-box", BasisFamily::parametric},
                                         Case{"cornell-box", BasisFamily::planar},
                                         Case{"stairs", BasisFamily::parametric}, Case{"stairs", BasisFamily::planar},
                                         Case{"next-room", BasisFamily::parametric}));

// Where light bounces on, what was found in a sweep is worth using in it.
TEST(RelaxationCost, LaterOrdersTakeFewerLinks) {
    const auto links_taken = [](GatherOrder order) {
        Setting setting{std::make_shared<const Scene>(open_scene("cornell-box")), Options{.threshold = 0.05, .tolerance = {}, .effects = {}, .gather = order}};
        setting.blockers = std::make_unique<const Blockers>(*setting.scene);
        Solver solver(setting.scene, setting.options);
        EXPECT_TRUE(solver.run());
        State links = *solver.state();
        links.counters.total_work = {};
        const Counters end = settled(setting, links).counters;
        return static_cast<double>(end.total_work.link_evaluations) / static_cast<double>(end.links);
    };
    const double jacobi = links_taken(GatherOrder::jacobi);
    EXPECT_LT(links_taken(GatherOrder::gauss_seidel), 0.75 * jacobi);
    EXPECT_LT(links_taken(GatherOrder::southwell), jacobi);
}

} // namespace
} // namespace penumbra
