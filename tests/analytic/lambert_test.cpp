// Lambert's formula against closed forms of other shapes.
#include "reference/form_factors.h"

#include "geometry/polygon.h"
#include "transport/lambert.h"

#include <gtest/gtest.h>

#include <array>

namespace penumbra {
namespace {

/// The plane z = height, front down, with the frame that keeps x and mirrors y.
PlaneFrame ceiling(double height) { return {Vec3(0, 0, height), Vec3::UnitX(), -Vec3::UnitY(), -Vec3::UnitZ()}; }

/// A regular polygon whose area is a disc's.
Polygon regular(int n, double radius) {
    const double angle = 2 * std::numbers::pi / n;
    const double reach = radius * std::sqrt(2 * std::numbers::pi / (n * std::sin(angle)));
    Polygon out;
    for (int k = 0; k < n; ++k)
        out.push_back(reach * Vec2(std::cos(k * angle), std::sin(k * angle)));
    return out;
}

TEST(Lambert, PolygonsTendToTheDisc) {
    // F = r^2 / (r^2 + h^2) on the axis, and times the cosine for a receiver that is tilted but sees all of the disc:
    // the irradiance vector lies in the axis. A polygon of the disc's area misses it by O(1/n^4): sixteenfold less for
    // twice the corners.
    const double r = 0.7, h = 1.1, disc = r * r / (r * r + h * h);
    for (const double tilt : {0.0, 0.4, 0.9}) {
        const Vec3 n(std::sin(tilt), 0, std::cos(tilt));
        const auto error = [&](int corners) {
            return std::abs(lambert(Vec3::Zero(), n, ceiling(h), regular(corners, r)) - disc * n.z());
        };
        EXPECT_LT(error(4096), 1e-12);
        EXPECT_NEAR(error(16) / error(32), 16, 0.5);
    }
}

TEST(Lambert, RectanglesOverheadAndTilted) {
    const std::array<std::array<double, 5>, 4> cases{
        {{0, 1, 0, 1, 1}, {-0.3, 1.2, 0.2, 0.9, 0.5}, {0.4, 0.5, -2, 3, 0.01}, {-3, -1, -2, -1.5, 2}}};
    for (const auto &[x0, x1, y0, y1, c] : cases) {
        const Polygon rectangle{{x0, -y1}, {x1, -y1}, {x1, -y0}, {x0, -y0}};
        const Vec3 vector = reference::rectangle_overhead(x0, x1, y0, y1, c);
        for (const Vec3 &direction : {Vec3(0, 0, 1), Vec3(0.001, 0, 1), Vec3(-0.0015, 0.002, 1)}) {
            const Vec3 n = direction.normalized();
            const double f = lambert(Vec3::Zero(), n, ceiling(c), rectangle);
            EXPECT_NEAR(f, vector.dot(n), 1e-14);
        }
    }
    // Well tilted, the whole rectangle still in front.
    const Polygon rectangle{{0, -1}, {1, -1}, {1, 0}, {0, 0}};
    const Vec3 n = Vec3(1, 2, 0.5).normalized();
    EXPECT_NEAR(lambert(Vec3::Zero(), n, ceiling(0.8), rectangle),
                reference::rectangle_overhead(0, 1, 0, 1, 0.8).dot(n), 1e-14);
}

TEST(Lambert, ARectangleFarAwayActsAsAPoint) {
    // Area times cosines over pi r^2, to the second order in size over distance.
    const Polygon small{{-5e-4, -5e-4}, {5e-4, -5e-4}, {5e-4, 5e-4}, {-5e-4, 5e-4}};
    const Vec3 x(1, 0.5, 0);
    const double r2 = 1 + 0.25 + 4;
    EXPECT_NEAR(lambert(x, Vec3::UnitZ(), ceiling(2), small) / (1e-6 * 4 / (std::numbers::pi * r2 * r2)), 1, 1e-6);
}

TEST(Lambert, AlmostAHemisphere) {
    const Polygon wide{{-1e6, -1e6}, {1e6, -1e6}, {1e6, 1e6}, {-1e6, 1e6}};
    EXPECT_NEAR(lambert(Vec3::Zero(), Vec3::UnitZ(), ceiling(1e-3), wide), 1, 1e-12);
}

} // namespace
} // namespace penumbra
