// The error of a link's coefficients that interaction.h allows, for pairs that see each other whole: far, near and
// touching, against integration that shares nothing with the solver's.
#include "analytic/links.h"
#include "reference/kernel_integrals.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace penumbra {
namespace {

constexpr double degrees = std::numbers::pi / 180;

/// Largest error of any coefficient, over what the header allows it; `times`: the accuracy, where that is 1e-4 or less.
double worst(const Pair &pair, const Eigen::MatrixXd &exact, int order, double accuracy, double times) {
    Work work;
    const Link link = pair.link(SurfaceId(0), SurfaceId(1), accuracy, work);
    // From 1e-4 on the accuracy is met whatever the fit misses.
    if (accuracy <= 1e-4)
        return (link.kernel - exact).cwiseAbs().maxCoeff() / (times * accuracy * exact(0, 0));
    double most = 0;
    for (Eigen::Index j = 0; j < exact.cols(); ++j) {
        // Of products of Legendre polynomials: sqrt(2k + 1) for each degree, at the corners.
        const auto degree = [&](Eigen::Index k) { return std::sqrt(2.0 * static_cast<double>(k) + 1); };
        const double largest = degree(j / order) * degree(j % order);
        const double allowed = accuracy * exact(0, 0) * largest + link.misfit.col(j).cwiseAbs().maxCoeff();
        most = std::max(most, (link.kernel.col(j) - exact.col(j)).cwiseAbs().maxCoeff() / allowed);
    }
    return most;
}

reference::Face face(const reference::Parallelogram &p) {
    return {{p.corner, p.corner + p.first, p.corner + p.first + p.second, p.corner + p.second}};
}

/// A parallelogram over the unit square, tilted by up to half a radian, its lowest corner `gap` above; the square lies
/// all in front of its plane.
reference::Parallelogram over_square(std::mt19937 &random, double gap) {
    const auto in = [&](double low, double high) { return low + (high - low) * (random() / 4294967296.0); };
    for (;;) {
        const double turn = in(0, 6.28), size = in(0.3, 1.5);
        const Eigen::Matrix3d tilt =
            Eigen::AngleAxisd(in(-0.5, 0.5), Vec3(std::cos(turn), std::sin(turn), 0)).toRotationMatrix() *
            Eigen::AngleAxisd(in(0, 6.28), Vec3::UnitZ()).toRotationMatrix();
        const Vec3 first = size * (tilt * Vec3::UnitY()), second = size * (tilt * Vec3(in(0.5, 1.2), in(-0.4, 0.4), 0));
        const double low = std::min({0.0, first.z(), second.z(), first.z() + second.z()});
        const Vec3 corner(in(-0.5, 1.5), in(-0.5, 1.5), gap - low), n = first.cross(second);
        double least = gap;
        for (const Vec3 &x : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(1, 1, 0)})
            least = std::min(least, n.dot(x - corner));
        if (least > 0)
            return {corner, first, second};
    }
}

TEST(Links, OfClearPairs) {
    const reference::Parallelogram square{Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY()};
    std::mt19937 random(11);
    for (int k = 0; k < 24; ++k) {
        const double gap = std::pow(10, 1 - 1.7 * (k % 8) / 7); // ten sides away to a fifth of one
        const reference::Parallelogram other = over_square(random, gap);
        const int order = 1 + k % 4;
        const Pair pair(face(square), face(other), order);
        const Eigen::MatrixXd exact = reference::clear_kernel(square, other, order);
        for (const double accuracy : {1e-2, 1e-3, 1e-4, 1e-5})
            EXPECT_LE(worst(pair, exact, order, accuracy, 20), 1) << k << ", gap " << gap << ", accuracy " << accuracy;
    }
}

TEST(Links, OfTouchingPairs) {
    std::mt19937 random(12);
    const auto in = [&](double low, double high) { return low + (high - low) * (random() / 4294967296.0); };
    for (int k = 0; k < 24; ++k) {
        // One edge, or the middle of one: where ends almost meet the reference would need more points.
        const bool whole = k % 2 == 0;
        const double length = in(0.5, 2), depth = in(0.5, 2), height = in(0.5, 2), angle = in(60, 150) * degrees;
        const double other = whole ? length : in(0.3, 0.5) * length,
                     shift = whole ? 0 : in(0.35, 0.65) * (length - other);
        const int order = 1 + k / 2 % 4;
        const Pair pair(lying(length, depth), turned_up(other, height, angle, shift), order);
        const auto reference = [&](int n) {
            return reference::hinged_kernel({0, length, depth}, {shift + other, shift, height}, angle, order, n);
        };
        const Eigen::MatrixXd exact = reference(30);
        ASSERT_LT((exact - reference(25)).cwiseAbs().maxCoeff(), 5e-5 * exact(0, 0)) << k;
        for (const double accuracy : {1e-2, 1e-3, 1e-4, 1e-5})
            EXPECT_LE(worst(pair, exact, order, accuracy, 100), 1) << k << ", accuracy " << accuracy;
    }
}

} // namespace
} // namespace penumbra
