// Every K_ij of a pair that shares an edge, without any subdivision, against independent integration.
#include "analytic/links.h"
#include "reference/form_factors.h"
#include "reference/kernel_integrals.h"

namespace penumbra {
namespace {

constexpr double degrees = std::numbers::pi / 180;

struct Hinge {
    const char *name;
    double length, depth;               ///< of the lying rectangle
    double other_length, height, angle; ///< of the other
    double shift;                       ///< along the hinge
};

constexpr Hinge hinges[] = {
    {"squares at a right angle", 1, 1, 1, 1, 90 * degrees, 0},
    {"rectangles at a right angle", 2, 0.5, 2, 1.5, 90 * degrees, 0},
    {"squares at 30 degrees", 1, 1, 1, 1, 30 * degrees, 0},
    {"squares at 150 degrees", 1, 1, 1, 1, 150 * degrees, 0},
    {"a part of the edge in common", 1, 1, 0.8, 0.6, 90 * degrees, 0.5},
    {"the edge of one inside the other's", 1, 1, 0.4, 0.6, 90 * degrees, 0.3},
};

reference::HingedRectangle lying_rectangle(const Hinge &h) { return {0, h.length, h.depth}; }
reference::HingedRectangle other_rectangle(const Hinge &h) { return {h.shift + h.other_length, h.shift, h.height}; }

TEST(TouchingPair, TheReferenceAgreesWithItselfAndWithTheClosedForm) {
    for (const Hinge &h : hinges) {
        const auto fine = reference::hinged_kernel(lying_rectangle(h), other_rectangle(h), h.angle, 4, 30);
        const auto coarse = reference::hinged_kernel(lying_rectangle(h), other_rectangle(h), h.angle, 4, 25);
        EXPECT_LT((fine - coarse).cwiseAbs().maxCoeff(), 1e-9) << h.name;
    }
    const auto cube = reference::hinged_kernel({0, 1, 1}, {1, 0, 1}, 90 * degrees, 1);
    EXPECT_NEAR(cube(0, 0), reference::perpendicular_rectangles(1, 1, 1), 1e-12);
    const auto flat = reference::hinged_kernel({0, 2, 0.5}, {0, 2, 1.5}, 90 * degrees, 1);
    EXPECT_NEAR(flat(0, 0), reference::perpendicular_rectangles(2, 0.5, 1.5), 1e-10);
}

TEST(TouchingPair, EveryCoefficientToOneInAMillion) {
    for (const Hinge &h : hinges) {
        for (int order = 1; order <= 4; ++order) {
            const Pair pair(lying(h.length, h.depth), turned_up(h.other_length, h.height, h.angle, h.shift), order);
            const auto there = reference::hinged_kernel(lying_rectangle(h), other_rectangle(h), h.angle, order);
            const auto back = reference::hinged_kernel(other_rectangle(h), lying_rectangle(h), h.angle, order);
            EXPECT_LT((pair.kernel(0, 1, 1e-7) - there).cwiseAbs().maxCoeff(), 1e-6)
                << h.name << ", order " << order;
            EXPECT_LT((pair.kernel(1, 0, 1e-7) - back).cwiseAbs().maxCoeff(), 1e-6)
                << h.name << ", order " << order;
        }
    }
}

} // namespace
} // namespace penumbra
