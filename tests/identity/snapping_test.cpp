// Cuts that pass a corner or another cut within rounding: no slivers, and what was moved is counted.
#include "hierarchy/cut.h"
#include "iteration/solver.h"
#include "iteration/state.h"
#include "reference/faces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace penumbra {
namespace {

Element element_of(const std::array<Vec2, 4> &corners) {
    Element e;
    e.basis = ElementBasis(1, BilinearQuad{corners});
    e.sides.assign(4, SideKind::outline);
    return e;
}

const std::array<Vec2, 4> square{Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)};

HalfPlane line_through(const Vec2 &a, const Vec2 &b) {
    const Vec2 d = (b - a).normalized();
    return {-d.y(), d.x(), cross(a, d)};
}

/// Leaves that a cut makes of each of these; those that it does not part stay.
std::vector<Element> cut_all(const std::vector<Element> &leaves, const HalfPlane &line) {
    std::vector<Element> next;
    for (const Element &leaf : leaves) {
        const auto plan = plan_cut(leaf, line);
        if (!plan)
            next.push_back(leaf);
        else
            for (const ElementBasis &piece : plan->leaves())
                next.push_back(element_of(piece.quad()->corners));
    }
    return next;
}

/// Area over the square of the longest diagonal: an equilateral triangle has 0.43, a square 0.5, a sliver nothing.
double plumpness(const Element &e) {
    double longest = 0;
    for (const Vec2 &a : e.basis.outline())
        for (const Vec2 &b : e.basis.outline())
            longest = std::max(longest, (a - b).norm());
    return e.basis.area() / (longest * longest);
}

double whole_area(const std::vector<Element> &leaves) {
    double sum = 0;
    for (const Element &e : leaves)
        sum += e.basis.area();
    return sum;
}

TEST(Snapping, AnEndNearACornerIsMovedThere) {
    for (const double off : {1e-16, 1e-12, 1e-8, 5e-7}) {
        const auto plan = plan_cut(element_of(square), line_through({off, 0}, {0.4, 1}));
        ASSERT_TRUE(plan) << off;
        EXPECT_EQ(plan->n_snapped, 1) << off;
        EXPECT_EQ(plan->steps.size(), 1u);
        // The corner itself ends the cut: a triangle is parted, with its corners 0 and 1 in one place.
        const auto is_triangle = [](const ElementBasis &e) { return e.outline().size() == 3; };
        EXPECT_EQ(std::ranges::count_if(plan->steps[0].children, is_triangle), 1) << off;
    }
    EXPECT_EQ(plan_cut(element_of(square), line_through({0, 0}, {0.4, 1}))->n_snapped, 0) << "met, not moved";
    EXPECT_EQ(plan_cut(element_of(square), line_through({1e-5, 0}, {0.4, 1}))->n_snapped, 0) << "far enough";
}

TEST(Snapping, ANearDiagonalIsTheDiagonal) {
    for (const double off : {1e-13, 1e-9, 3e-7}) {
        const auto plan = plan_cut(element_of(square), line_through({off, 0}, {1, 1 - off}));
        ASSERT_TRUE(plan) << off;
        EXPECT_EQ(plan->n_snapped, 2) << off;
        const auto leaves = plan->leaves();
        ASSERT_EQ(leaves.size(), 2u) << "no extra step";
        for (const ElementBasis &leaf : leaves)
            EXPECT_EQ(leaf.area(), 0.5);
    }
}

TEST(Snapping, WhatRunsAlongASideOrPastACornerPartsNothing) {
    for (const double off : {0.0, 1e-15, 1e-12, 1e-7}) {
        EXPECT_FALSE(plan_cut(element_of(square), line_through({0, off}, {1, off})));
        EXPECT_FALSE(plan_cut(element_of(square), line_through({0, off}, {1, -off})));
        EXPECT_FALSE(plan_cut(element_of(square), line_through({0, off}, {off, 0})));
    }
}

TEST(Snapping, OfTwoCutsWithinRoundingOneIsMade) {
    const auto first = cut_all({element_of(square)}, line_through({0.5, 0}, {0.3, 1}));
    ASSERT_EQ(first.size(), 2u);
    for (const double off : {1e-15, 1e-12, 1e-9, -1e-12, 2e-7})
        EXPECT_EQ(cut_all(first, line_through({0.5 + off, 0}, {0.3 + off, 1})).size(), 2u) << off;
    // Crossing it within rounding, too: neither side gets a sliver.
    EXPECT_EQ(cut_all(first, line_through({0.5 - 1e-12, 0}, {0.3 + 1e-12, 1})).size(), 2u);
}

TEST(Snapping, AFanThroughNearlyOnePointLeavesNoSlivers) {
    // 24 lines, 7.5 degrees apart, that miss one point by up to `off`. The thinnest wedge between two has
    // sin(7.5 degrees) / 2 = 0.065 where its sides are equally long; the extra steps of section 4 part it again.
    std::mt19937 random(3);
    std::uniform_real_distribution<double> uniform(-1, 1);
    for (const double off : {0.0, 1e-15, 1e-12, 1e-11}) {
        std::vector<Element> leaves{element_of(square)};
        for (int k = 0; k < 24; ++k) {
            const double angle = k * M_PI / 24 + 0.01;
            const Vec2 near(0.41 + off * uniform(random), 0.57 + off * uniform(random));
            leaves = cut_all(leaves, line_through(near, near + Vec2(std::cos(angle), std::sin(angle))));
        }
        EXPECT_NEAR(whole_area(leaves), 1, 1e-12);
        double thinnest = 1;
        for (const Element &leaf : leaves)
            thinnest = std::min(thinnest, plumpness(leaf));
        EXPECT_GT(thinnest, 1e-3) << off;
        EXPECT_LE(leaves.size(), 60u) << "48 wedges, and what the extra steps part";
    }
}

TEST(Snapping, TheSolverCountsIt) {
    // Lamp and blocker have edges along x + y = const, so that the shadow's borders on the floor are x + y = 2 s - a
    // for the lamp's edges a, and the blocker's s: one misses the floor's diagonal x + y = 1 by 1e-8.
    const double s = 0.9, a = 0.8 - 1e-8, b = 0.4;
    const auto along = [](double sum, double difference, double z) {
        return Vec3((sum + difference) / 2, (sum - difference) / 2, z);
    };
    const auto scene = reference::scene_of(
        {{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}},
         {{along(a, -3, 1), along(a, 3, 1), along(b, 3, 1), along(b, -3, 1)}, Rgb::Zero(), Rgb::Ones()},
         {{along(s, 4, 0.5), along(s + 4, 4, 0.5), along(s + 4, -4, 0.5), along(s, -4, 0.5)}, Rgb::Zero()}});
    Options options;
    options.threshold = 0.01;
    Solver solver(scene, options);
    solver.run();
    EXPECT_EQ(solver.counters().total_work.snapped_cuts, 2);
}

} // namespace
} // namespace penumbra
