// K_ij = the integral over both parameter squares of N_i G N_j times the source's Jacobian alone (the paper's (3)), for
// quads and triangles whose Jacobians are not constant, by a plain tensor rule.
#include "analytic/links.h"

#include <boost/math/quadrature/gauss.hpp>

#include <cmath>
#include <numbers>

namespace penumbra {
namespace {

using Corners = std::vector<Vec3>; // three or four

struct Point {
    Vec3 x;
    double jacobian;
};

/// The bilinear map; a triangle is a quad whose last corner counts twice.
Point at(const Corners &c, double u, double v) {
    const Vec3 &last = c.back(), &third = c[2];
    const Vec3 du = (1 - v) * (c[1] - c[0]) + v * (third - last), dv = (1 - u) * (last - c[0]) + u * (third - c[1]);
    return {(1 - u) * (1 - v) * c[0] + u * (1 - v) * c[1] + u * v * third + (1 - u) * v * last, du.cross(dv).norm()};
}

Eigen::VectorXd functions(int order, double u, double v) {
    const auto legendre = [](int k, double t) {
        return std::sqrt(2 * k + 1) * std::legendre(static_cast<unsigned>(k), 2 * t - 1);
    };
    Eigen::VectorXd values(order * order);
    for (int i = 0; i < order; ++i)
        for (int j = 0; j < order; ++j)
            values[i * order + j] = legendre(i, u) * legendre(j, v);
    return values;
}

Vec3 normal_of(const Corners &c) { return (c[1] - c[0]).cross(c[2] - c[0]).normalized(); }

Eigen::MatrixXd plain_kernel(const Corners &p, const Corners &q, int order) {
    using Gauss = boost::math::quadrature::gauss<double, 14>;
    std::vector<std::pair<double, double>> rule;
    for (std::size_t i = 0; i < Gauss::abscissa().size(); ++i)
        for (const double sign : {-1.0, 1.0})
            rule.emplace_back((1 + sign * Gauss::abscissa()[i]) / 2, Gauss::weights()[i] / 2);
    const Vec3 here = normal_of(p), there = normal_of(q);
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(order * order, order * order);
    for (const auto &[u, wu] : rule)
        for (const auto &[v, wv] : rule) {
            const Point x = at(p, u, v);
            Eigen::VectorXd moments = Eigen::VectorXd::Zero(order * order);
            for (const auto &[s, ws] : rule)
                for (const auto &[t, wt] : rule) {
                    const Point y = at(q, s, t);
                    const Vec3 d = y.x - x.x;
                    const double r2 = d.squaredNorm();
                    const double g = here.dot(d) * -there.dot(d) / (std::numbers::pi * r2 * r2);
                    moments += ws * wt * y.jacobian * g * functions(order, s, t);
                }
            sum += wu * wv * functions(order, u, v) * moments.transpose();
        }
    return sum;
}

TEST(ClearPair, EveryCoefficientOfQuadsAndTriangles) {
    const Corners quad{{0, 0, 0}, {1, 0.1, 0}, {0.8, 0.7, 0}, {0.1, 1, 0}},
        triangle{{0, 0, 0}, {1, 0, 0}, {0.3, 0.9, 0}};
    const Corners over{{0.2, 0.9, 1.2}, {1, 0.8, 1.2}, {0.7, 0.1, 1.2}, {0.1, 0.2, 1.2}};
    const Corners side{{-0.6, 0.1, 0.3}, {-0.6, 1, 0.2}, {-0.6, 0.6, 1.1}};
    for (const Corners &p : {quad, triangle})
        for (const Corners &q : {over, side})
            for (int order = 1; order <= 4; ++order) {
                const Pair pair(reference::Face{p}, reference::Face{q}, order);
                EXPECT_LT((pair.kernel(0, 1, 1e-7) - plain_kernel(p, q, order)).cwiseAbs().maxCoeff(), 1e-6)
                    << p.size() << " and " << q.size() << " corners, order " << order;
                EXPECT_LT((pair.kernel(1, 0, 1e-7) - plain_kernel(q, p, order)).cwiseAbs().maxCoeff(), 1e-6)
                    << q.size() << " and " << p.size() << " corners, order " << order;
            }
}

} // namespace
} // namespace penumbra
