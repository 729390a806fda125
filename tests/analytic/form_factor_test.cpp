// K_00 of a link is a form factor.
#include "analytic/links.h"
#include "reference/form_factors.h"

namespace penumbra {
namespace {

constexpr double right_angle = std::numbers::pi / 2;

TEST(FormFactor, OppositeRectangles) {
    for (const auto &[a, b, c] : {std::array{1.0, 1.0, 1.0}, {2.0, 0.7, 0.9}, {1.0, 1.0, 0.25}, {1.0, 1.0, 8.0}}) {
        const Pair pair(reference::Face{{{0, 0, 0}, {a, 0, 0}, {a, b, 0}, {0, b, 0}}},
                        reference::Face{{{0, 0, c}, {0, b, c}, {a, b, c}, {a, 0, c}}}, 4);
        EXPECT_NEAR(pair.kernel(0, 1, 1e-7)(0, 0), reference::parallel_rectangles(a, b, c), 1e-6) << c;
        EXPECT_NEAR(pair.kernel(1, 0, 1e-7)(0, 0), reference::parallel_rectangles(a, b, c), 1e-6) << c;
    }
}

TEST(FormFactor, UnitSquaresOfACube) {
    // Two printed values that everybody knows: 0.1998 and 0.2000.
    EXPECT_NEAR(reference::parallel_rectangles(1, 1, 1), 0.199825, 5e-7);
    EXPECT_NEAR(reference::perpendicular_rectangles(1, 1, 1), 0.200044, 5e-7);
}

TEST(FormFactor, PerpendicularRectanglesThatShareAnEdge) {
    for (const auto &[length, depth, height] : {std::array{1.0, 1.0, 1.0}, {2.0, 0.5, 1.5}, {0.5, 1.0, 0.8}}) {
        const Pair pair(lying(length, depth), turned_up(length, height, right_angle), 2);
        EXPECT_NEAR(pair.kernel(0, 1, 1e-7)(0, 0), reference::perpendicular_rectangles(length, depth, height), 1e-7);
        EXPECT_NEAR(pair.kernel(1, 0, 1e-7)(0, 0), reference::perpendicular_rectangles(length, height, depth), 1e-7);
    }
}

TEST(FormFactor, TheOraclesAccuracyHoldsForTouchingPairs) {
    // What the solver works with at its usual thresholds: 'accuracy' of K_00.
    const Pair pair(lying(1, 1), turned_up(1, 1, right_angle), 4);
    const double exact = reference::perpendicular_rectangles(1, 1, 1);
    for (const double accuracy : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6})
        EXPECT_NEAR(pair.kernel(0, 1, accuracy)(0, 0), exact, std::max(accuracy, 2e-7) * exact) << accuracy;
}

} // namespace
} // namespace penumbra
