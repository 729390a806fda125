// |A_p| K_pq = |A_q| K_qp^T where both elements are parallelograms; the paper's links have no reciprocity elsewhere.
#include "analytic/links.h"

namespace penumbra {
namespace {

double asymmetry(const Pair &pair) {
    const Eigen::MatrixXd there = pair.scene->surfaces[0].area * pair.kernel(0, 1, 1e-7);
    const Eigen::MatrixXd back = pair.scene->surfaces[1].area * pair.kernel(1, 0, 1e-7);
    return (there - back.transpose()).cwiseAbs().maxCoeff() / there(0, 0);
}

TEST(Reciprocity, OfParallelograms) {
    const reference::Face floor{{{0, 0, 0}, {1.2, 0.2, 0}, {1.5, 1.1, 0}, {0.3, 0.9, 0}}};
    const reference::Face tilted{{{0.1, 0.2, 0.9}, {0.3, 1.0, 1.1}, {1.1, 1.1, 0.8}, {0.9, 0.3, 0.6}}};
    for (int order = 1; order <= 4; ++order)
        EXPECT_LT(asymmetry(Pair(floor, tilted, order)), 5e-6) << order;
}

TEST(Reciprocity, OfATouchingPair) {
    for (int order = 1; order <= 4; ++order)
        EXPECT_LT(asymmetry(Pair(lying(1, 0.6), turned_up(1, 1.3, 2.0), order)), 5e-6) << order;
}

TEST(Reciprocity, FailsForATrapezoid) {
    // The control: with a Jacobian that is not constant it must not hold.
    const reference::Face trapezoid{{{0, 0, 0}, {1, 0, 0}, {0.7, 1, 0}, {0.3, 1, 0}}};
    const reference::Face over{{{0, 0, 1}, {0, 1, 1}, {1, 1, 1}, {1, 0, 1}}};
    EXPECT_GT(asymmetry(Pair(trapezoid, over, 2)), 1e-3);
}

} // namespace
} // namespace penumbra
