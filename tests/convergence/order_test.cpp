// On an unoccluded pair the error of order M falls as h^M, h the side of the elements.
#include "reference/faces.h"
#include "reference/form_factors.h"

#include "iteration/solver.h"

#include <gtest/gtest.h>

#include <cmath>

namespace penumbra {
namespace {

// A floor 1 x 1 under a lamp at height 0.6 that hangs off its middle; the lamp emits 1 W/m2, the floor reflects half.
constexpr double x0 = 0.2, x1 = 0.9, y0 = -0.1, y1 = 0.5, height = 0.6, rho = 0.5;

std::shared_ptr<const Scene> floor_and_lamp() {
    return reference::scene_of(
        {{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, Rgb::Constant(rho)},
         {{{x0, y0, height}, {x0, y1, height}, {x1, y1, height}, {x1, y0, height}}, Rgb::Zero(), Rgb::Ones()}});
}

double exact(const Vec3 &x) {
    return rho * reference::rectangle_overhead(x0 - x.x(), x1 - x.x(), y0 - x.y(), y1 - x.y(), height).z();
}

/// L2 error on the floor, relative, of uniform elements of this depth.
double error(int order, BasisFamily family, int depth) {
    Options options;
    options.strategy = order == 1 ? Strategy::uniform_constant : Strategy::uniform_wavelet;
    options.order = order;
    options.basis = family;
    options.threshold = 1e-14; // every element fails the oracle until the depth limit
    options.max_depth = depth;
    Solver solver(floor_and_lamp(), options);
    const int n_halvings = family == BasisFamily::planar ? 2 * depth : depth;
    for (int i = 0; i <= n_halvings + 1; ++i)
        solver.step();
    const auto snapshot = solver.snapshot();
    EXPECT_EQ(snapshot->counters.patches, 1 << 2 * depth);
    double squares = 0, whole = 0;
    constexpr int n = 7;
    for (const SnapshotPatch &patch : snapshot->patches) {
        if (patch.surface != 0)
            continue;
        const SnapshotSurface &plane = snapshot->surfaces[0];
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j) {
                // Children of a uniform split of a square are squares of one size: all points count the same.
                const Vec2 p = patch.corners[0] + (i + 0.5) / n * (patch.corners[1] - patch.corners[0]) +
                               (j + 0.5) / n * (patch.corners[3] - patch.corners[0]);
                const double b = exact(plane.origin + p.x() * plane.u + p.y() * plane.v);
                const double off = radiosity(*snapshot, patch, p).x() - b;
                squares += off * off;
                whole += b * b;
            }
    }
    return std::sqrt(squares / whole);
}

class Order : public testing::TestWithParam<std::tuple<int, BasisFamily>> {};

TEST_P(Order, TheErrorFallsAsItsPowerOfTheElementsSide) {
    const auto [order, family] = GetParam();
    const int finest = order == 1 ? 6 : order == 2 ? 5 : 4;
    // Least squares of log2 error over depth.
    double n = 0, sum_d = 0, sum_e = 0, sum_dd = 0, sum_de = 0;
    for (int depth = finest - 2; depth <= finest; ++depth) {
        const double e = std::log2(error(order, family, depth));
        RecordProperty("log2_error_at_depth_" + std::to_string(depth), std::to_string(e));
        n += 1;
        sum_d += depth;
        sum_e += e;
        sum_dd += depth * depth;
        sum_de += depth * e;
    }
    const double slope = (n * sum_de - sum_d * sum_e) / (n * sum_dd - sum_d * sum_d);
    EXPECT_NEAR(-slope, order, 0.2);
}

INSTANTIATE_TEST_SUITE_P(OneToFour, Order,
                         testing::Combine(testing::Values(1, 2, 3, 4),
                                          testing::Values(BasisFamily::parametric, BasisFamily::planar)));

} // namespace
} // namespace penumbra
