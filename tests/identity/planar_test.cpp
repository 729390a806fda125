// The planar basis: orthonormal on any convex polygon, and push and pull that lose nothing over any cut.
#include "hierarchy/cut.h"
#include "hierarchy/forest.h"
#include "reference/faces.h"

#include <boost/math/quadrature/gauss.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

namespace penumbra {
namespace {

using Gauss = boost::math::quadrature::gauss<double, 15>;

Polygon random_convex(std::mt19937 &random, double aspect) {
    std::uniform_real_distribution<double> unit;
    Polygon points;
    for (int i = 0; i < 9; ++i)
        points.emplace_back(unit(random), aspect * unit(random));
    const double angle = 6.28 * unit(random);
    const Eigen::Rotation2Dd turn(angle);
    for (Vec2 &p : points)
        p = turn * p + Vec2(0.3, -0.2);
    return convex_hull(points);
}

/// The integral over a triangle by a collapsed rule of the test's own.
template <class F>
void over_triangle(const Vec2 &a, const Vec2 &b, const Vec2 &c, const F &add) {
    const double doubled = cross(b - a, c - a);
    const auto each = [](const auto &visit) {
        for (std::size_t i = 0; i < Gauss::abscissa().size(); ++i)
            for (const double sign : {-1.0, 1.0})
                if (i > 0 || sign > 0)
                    visit((1 + sign * Gauss::abscissa()[i]) / 2, Gauss::weights()[i] / 2);
    };
    each([&](double s, double ws) {
        each([&](double t, double wt) { add(a + s * (b - a) + s * t * (c - b), ws * wt * s * doubled); });
    });
}

TEST(PlanarBasis, OrthonormalOverThePolygon) {
    std::mt19937 random(1);
    for (const double aspect : {1.0, 0.1, 1e-3, 1e-6})
        for (int order = 1; order <= 4; ++order) {
            const PlanarElement element(order, PlanarDomain(random_convex(random, aspect)));
            const Polygon &own = element.domain.corners();
            const int n = n_planar_functions(order);
            Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(n, n);
            double area = 0;
            for (std::size_t k = 1; k + 1 < own.size(); ++k)
                over_triangle(own[0], own[k], own[k + 1], [&](const Vec2 &p, double weight) {
                    const PlanarValues values = element.evaluate(p);
                    gram += weight * values * values.transpose();
                    area += weight;
                });
            EXPECT_LT((gram / area - Eigen::MatrixXd::Identity(n, n)).cwiseAbs().maxCoeff(), 1e-13)
                << "order " << order << ", aspect " << aspect;
        }
}

/// In the plane a point of a sliver of aspect 1e6 has lost half of its digits, and no more.
TEST(PlanarBasis, IsAPolynomialOfThePlane) {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> unit;
    for (int order = 2; order <= 4; ++order) {
        const Polygon polygon = random_convex(random, 0.7);
        const ElementBasis basis(order, PlanarDomain(polygon));
        // A polynomial's (order)th differences along a line vanish.
        const Vec2 from = polygon[0], step(unit(random) - 0.5, unit(random) - 0.5);
        BasisValues difference = BasisValues::Zero(basis.n_functions());
        double binomial = 1;
        for (int k = 0; k <= order; ++k) {
            difference += (k % 2 ? -binomial : binomial) * basis.evaluate(from + k * step);
            binomial = binomial * (order - k) / (k + 1);
        }
        EXPECT_LT(difference.cwiseAbs().maxCoeff(), 1e-9) << order;
    }
}

TEST(PlanarBasis, ProductsAreTheSameFunctions) {
    std::mt19937 random(3);
    for (int order = 1; order <= 4; ++order) {
        const Polygon polygon = random_convex(random, 0.3);
        const ElementBasis basis(order, PlanarDomain(polygon));
        const Eigen::MatrixX3d b = Eigen::MatrixX3d::Random(basis.n_functions(), 3);
        const Eigen::MatrixX3d products = basis.product_coefficients(b);
        const ElementBasis box(order, basis.product_quad());
        const Vec2 p = centroid(polygon);
        const Eigen::RowVector3d difference =
            basis.evaluate(p).transpose() * b - box.evaluate(p).transpose() * products;
        EXPECT_LT(difference.cwiseAbs().maxCoeff(), 1e-12) << order;
    }
}

Forest planar_forest(const Polygon &polygon, int order) {
    reference::Face face;
    for (const Vec2 &c : polygon)
        face.corners.emplace_back(c.x(), c.y(), 0);
    return plant(*reference::scene_of({face}), order, BasisFamily::planar);
}

/// Largest entry of the sum over the children of pull push - I.
double loss(const Forest &forest, const Element &parent) {
    const int n = parent.basis.n_functions();
    Eigen::MatrixXd sum = -Eigen::MatrixXd::Identity(n, n);
    for (int c = 0; c < parent.n_children; ++c) {
        const TwoScale &filters = *forest[ElementId(parent.first_child.index + c)].filters;
        sum += filters.pull * filters.push;
    }
    return sum.cwiseAbs().maxCoeff();
}

/// Cuts the leaf along a random line of its frame that leaves at least a part of the given share; false when it misses.
bool cut_at_random(Forest &forest, ElementId leaf, double share, std::mt19937 &random) {
    std::uniform_real_distribution<double> unit;
    const PlanarDomain &domain = forest[leaf].basis.planar()->domain;
    // A line of the element's own frame near its border, so that one part is a sliver.
    const double angle = 6.28 * unit(random);
    const Vec2 normal(std::cos(angle), std::sin(angle));
    double low = 1e300, high = -1e300;
    for (const Vec2 &p : domain.corners()) {
        low = std::min(low, p.dot(normal));
        high = std::max(high, p.dot(normal));
    }
    const Vec2 at = (low + share * (high - low)) * normal;
    const Vec2 a = domain.to_plane()(at), b = domain.to_plane()(at + Vec2(-normal.y(), normal.x()));
    const Vec2 d = (b - a).normalized();
    const auto plan = plan_cut(forest[leaf], {-d.y(), d.x(), cross(a, d)});
    if (plan)
        cut(forest, leaf, *plan, 1);
    return plan.has_value();
}

TEST(PlanarCut, RoundTripLosesNothing) {
    std::mt19937 random(4);
    double most = 0;
    int n_cuts = 0;
    for (int order = 1; order <= 4; ++order)
        for (int k = 0; k < 200; ++k)
            for (const double share : {0.5, 0.2, 1e-2, 1e-4}) {
                Forest forest = planar_forest(random_convex(random, k % 2 ? 1 : 1e-3), order);
                if (!cut_at_random(forest, ElementId(0), share, random))
                    continue;
                ++n_cuts;
                most = std::max(most, loss(forest, forest.elements[0]));
            }
    std::printf("%d cuts, largest loss %.2g\n", n_cuts, most);
    EXPECT_GT(n_cuts, 2000);
    EXPECT_LE(most, 1e-12);
}

/// Twenty cuts one below the other, slivers of aspect up to 1e6 among them: push down and pull up all the way.
TEST(PlanarCut, ChainsOfTwentyLoseNothing) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit;
    double most = 0, thinnest = 1;
    for (int order = 1; order <= 4; ++order)
        for (int chain = 0; chain < 40; ++chain) {
            Forest forest = planar_forest(random_convex(random, chain % 2 ? 1 : 1e-6), order);
            ElementId leaf(0);
            for (int level = 0; level < 20;) {
                if (!cut_at_random(forest, leaf, 0.02 + 0.96 * unit(random), random))
                    continue;
                ++level;
                leaf = ElementId(forest[leaf].first_child.index + (unit(random) < 0.5));
                const Polygon outline = forest[leaf].basis.outline();
                thinnest = std::min(thinnest, area(outline) / std::pow(2 * radius(outline), 2));
            }
            const int n = forest.elements[0].basis.n_functions();
            Eigen::MatrixXd sum = -Eigen::MatrixXd::Identity(n, n);
            for_each_leaf(forest, ElementId(0), [&](ElementId end) {
                Eigen::MatrixXd down = Eigen::MatrixXd::Identity(n, n), up = down;
                for (ElementId e = end; forest[e].parent.valid(); e = forest[e].parent) {
                    down = down * forest[e].filters->push;
                    up = forest[e].filters->pull * up;
                }
                sum += up * down;
            });
            most = std::max(most, sum.cwiseAbs().maxCoeff());
        }
    std::printf("thinnest element: area %.2g of its diameter squared; largest loss %.2g\n", thinnest, most);
    EXPECT_LT(thinnest, 1e-6);
    EXPECT_LE(most, 1e-12);
}

TEST(PlanarCut, PullIsTheShareOfTheAreaTimesPushTransposed) {
    std::mt19937 random(6);
    for (int order = 1; order <= 4; ++order) {
        Forest forest = planar_forest(random_convex(random, 0.6), order);
        ASSERT_TRUE(cut_at_random(forest, ElementId(0), 0.3, random));
        subdivide(forest, ElementId(1), 2);
        for (std::size_t e = 1; e < forest.elements.size(); ++e) {
            const Element &child = forest.elements[e];
            const double share = area(child.basis.outline()) / area(forest[child.parent].basis.outline());
            EXPECT_LT((child.filters->pull - share * child.filters->push.transpose()).cwiseAbs().maxCoeff(), 1e-13);
        }
        EXPECT_LT(loss(forest, forest.elements[1]), 1e-13);
    }
}

/// What push gives is the parent's own polynomial on the child.
TEST(PlanarCut, PushKeepsTheFunction) {
    std::mt19937 random(7);
    Forest forest = planar_forest(random_convex(random, 0.6), 4);
    ASSERT_TRUE(cut_at_random(forest, ElementId(0), 0.4, random));
    const Eigen::VectorXd b = Eigen::VectorXd::Random(10);
    for (std::size_t e = 1; e <= 2; ++e) {
        const Element &child = forest.elements[e];
        const Eigen::VectorXd pushed = child.filters->push * b;
        for (const Vec2 &p : child.basis.outline())
            EXPECT_NEAR(child.basis.evaluate(p).dot(pushed), forest.elements[0].basis.evaluate(p).dot(b), 1e-11);
    }
}

} // namespace
} // namespace penumbra
