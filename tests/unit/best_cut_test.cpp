// The best straight cut across a node, on fields whose best cut is known.
#include "iteration/best_cut.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace penumbra {
namespace {

Element square(int order) {
    Element e;
    e.basis = ElementBasis(order, BilinearQuad{{Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)}});
    return e;
}

/// As sample_field lays them out: 12 x 12 points of equal weight.
SampledField field_of(const auto &value) {
    SampledField field;
    field.values.resize(144, 3);
    for (int i = 0; i < 12; ++i)
        for (int j = 0; j < 12; ++j) {
            const Vec2 p((i + 0.5) / 12, (j + 0.5) / 12);
            field.values.row(static_cast<Eigen::Index>(field.points.size())).setConstant(value(p));
            field.points.push_back(p);
            field.areas.push_back(1.0 / 144);
        }
    return field;
}

/// The two ends of the cut that a plan of one step makes.
std::pair<Vec2, Vec2> ends(const CutPlan &plan) {
    // The side that both quads have.
    const auto &a = plan.steps[0].quads[0].corners, &b = plan.steps[0].quads[1].corners;
    std::vector<Vec2> common;
    for (const Vec2 &p : a)
        if (std::ranges::find(b, p) != b.end() && std::ranges::find(common, p) == common.end())
            common.push_back(p);
    EXPECT_EQ(common.size(), 2u);
    return {common.front(), common.back()};
}

TEST(BestCut, FollowsAStep) {
    // 1 right of the line from (0.3, 0) to (0.6, 1), 0 left of it. Samples lie a twelfth apart: no line between the
    // same samples is better or worse.
    for (const int order : {1, 2, 4}) {
        const SampledField field = field_of([](const Vec2 &p) { return p.x() > 0.3 + 0.3 * p.y() ? 1.0 : 0.0; });
        const auto plan = best_cut(square(order), field);
        ASSERT_TRUE(plan);
        ASSERT_EQ(plan->steps.size(), 1u) << "between opposite sides";
        const auto [p, q] = ends(*plan);
        for (const Vec2 &end : {p, q})
            EXPECT_NEAR(end.x(), 0.3 + 0.3 * end.y(), 1.0 / 12) << "order " << order;
        EXPECT_EQ(plan->half_depth, 1) << "a bisection";
    }
}

TEST(BestCut, FollowsAKink) {
    const auto kink = [](const Vec2 &p) { return std::max(0.0, p.y() - 0.55 + 0.2 * p.x()); };
    const auto plan = best_cut(square(2), field_of(kink));
    ASSERT_TRUE(plan);
    const auto [p, q] = ends(*plan);
    for (const Vec2 &end : {p, q})
        EXPECT_NEAR(end.y(), 0.55 - 0.2 * end.x(), 1.0 / 12);
}

TEST(BestCut, ThereIsNoneWhereTheFitIsExact) {
    // A linear field, which order 2 holds: what a cut could remove is rounding.
    const SampledField field = field_of([](const Vec2 &p) { return 1 + p.x() - 0.5 * p.y(); });
    const auto plan = best_cut(square(2), field);
    if (plan) {
        const double removed = misfit(field, square(2).basis.quad(), 2) - misfit(field, plan->leaves(), 2);
        EXPECT_LT(removed, 1e-20);
    }
}

} // namespace
} // namespace penumbra
