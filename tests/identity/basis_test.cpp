// Orthonormality, filters and projections, over shapes of all kinds. Integrals are the test's own: a
// rule of Boost.Math on the unit square and a map written down here.
#include "basis/element_basis.h"
#include "basis/two_scale.h"
#include "hierarchy/forest.h"
#include "hierarchy/push_pull.h"
#include "reference/faces.h"

#include <boost/math/quadrature/gauss.hpp>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace penumbra {
namespace {

using Gauss = boost::math::quadrature::gauss<double, 15>;

const BilinearQuad shapes[] = {
    {{Vec2(0, 0), Vec2(2, 0), Vec2(2, 1), Vec2(0, 1)}},           // rectangle
    {{Vec2(0, 0), Vec2(1, 0.2), Vec2(1.4, 1.2), Vec2(0.4, 1)}},   // parallelogram
    {{Vec2(0, 0), Vec2(1, 0), Vec2(0.9, 0.7), Vec2(0.2, 1.1)}},   // nothing special
    {{Vec2(0, 0), Vec2(1, 0), Vec2(0.5, 1e-3), Vec2(0.4, 1e-3)}}, // flat
    {{Vec2(0, 0), Vec2(1, 0), Vec2(0.3, 0.8), Vec2(0.3, 0.8)}},   // triangle
};

Vec2 map(const std::array<Vec2, 4> &c, double u, double v) {
    return (1 - u) * (1 - v) * c[0] + u * (1 - v) * c[1] + u * v * c[2] + (1 - u) * v * c[3];
}

/// The integral of f(u, v) over the unit square.
template <class F>
auto over_square(const F &f) {
    decltype(f(0.5, 0.5)) sum = 0 * f(0.5, 0.5);
    for (std::size_t i = 0; i < Gauss::abscissa().size(); ++i)
        for (const double a : {-1.0, 1.0})
            for (std::size_t j = 0; j < Gauss::abscissa().size(); ++j)
                for (const double b : {-1.0, 1.0}) {
                    if ((i == 0 && a > 0) || (j == 0 && b > 0))
                        continue; // the middle point once
                    sum += Gauss::weights()[i] * Gauss::weights()[j] / 4 *
                           f((1 + a * Gauss::abscissa()[i]) / 2, (1 + b * Gauss::abscissa()[j]) / 2);
                }
    return sum;
}

TEST(Basis, OrthonormalInTheParameterSquare) {
    for (const BilinearQuad &shape : shapes)
        for (int order = 1; order <= 4; ++order) {
            const ElementBasis basis(order, shape);
            const auto gram = over_square([&](double u, double v) -> Eigen::MatrixXd {
                const BasisValues n = basis.evaluate(map(shape.corners, u, v));
                return n * n.transpose();
            });
            const auto identity = Eigen::MatrixXd::Identity(order * order, order * order);
            EXPECT_LT((gram - identity).cwiseAbs().maxCoeff(), 1e-11) << order;
        }
}

TEST(Basis, ItsOwnRuleIntegratesTheSame) {
    for (const BilinearQuad &shape : shapes)
        for (int order = 1; order <= 4; ++order) {
            const ElementBasis basis(order, shape);
            Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(order * order, order * order);
            double inner = 0, area = 0;
            for (const QuadraturePoint &q : basis.quadrature(order)) {
                const BasisValues n = basis.evaluate(q.position);
                gram += q.inner * n * n.transpose();
                inner += q.inner;
                area += q.area;
            }
            EXPECT_LT((gram - Eigen::MatrixXd::Identity(order * order, order * order)).cwiseAbs().maxCoeff(), 1e-11);
            EXPECT_NEAR(inner, 1, 1e-14);
            EXPECT_NEAR(area, basis.area(), 1e-14); // the Jacobian is linear in both parameters
        }
}

TEST(Basis, TheFirstFunctionIsOne) {
    for (const BilinearQuad &shape : shapes)
        EXPECT_EQ(ElementBasis(4, shape).evaluate(shape.at(0.3, 0.6))[0], 1);
}

TEST(Filters, PredefinedOnesEqualThoseOfAnyElement) {
    for (const BilinearQuad &shape : shapes)
        for (int order = 1; order <= 4; ++order) {
            const ElementBasis parent(order, shape);
            const auto children = uniform_children(shape);
            for (std::size_t c = 0; c < 4; ++c) {
                // The definitions: push_ij = <N_i, N_j of the parent> on the child, pull a quarter of its transpose.
                const ElementBasis child(order, children[c]);
                const auto push = over_square([&](double u, double v) -> Eigen::MatrixXd {
                    const Vec2 p = map(children[c].corners, u, v);
                    return child.evaluate(p) * parent.evaluate(p).transpose();
                });
                const TwoScale computed = two_scale(parent, child);
                const TwoScale &fixed = *uniform_two_scale(order)[c];
                EXPECT_LT((fixed.push - push).cwiseAbs().maxCoeff(), 1e-10);
                EXPECT_LT((fixed.pull - push.transpose() / 4).cwiseAbs().maxCoeff(), 1e-10);
                EXPECT_LT((computed.push - push).cwiseAbs().maxCoeff(), 1e-10);
                EXPECT_LT((computed.pull - fixed.pull).cwiseAbs().maxCoeff(), 1e-10);
            }
        }
}

TEST(Filters, ARoundTripOverUniformChildrenLosesNothing) {
    for (int order = 1; order <= 4; ++order) {
        Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(order * order, order * order);
        for (const auto &child : uniform_two_scale(order))
            sum += child->pull * child->push;
        EXPECT_LT((sum - Eigen::MatrixXd::Identity(order * order, order * order)).cwiseAbs().maxCoeff(), 1e-13);
    }
}

TEST(Projection, OfEmission) {
    // E is constant on a surface, and so is its projection: at every leaf, cut or not, and pulled to every root.
    const Rgb glow(3, 0.5, 7);
    const auto scene = reference::scene_of({{{{0, 0, 0}, {2, 0, 0}, {1.7, 1, 0}, {0.2, 1.4, 0}}, Rgb::Zero(), glow}});
    for (int order = 1; order <= 4; ++order) {
        Forest forest = plant(*scene, order);
        subdivide(forest, ElementId(0), 1);
        subdivide(forest, ElementId(2), 1);
        Coefficients b, none = Coefficients::Zero(forest.n_coefficients, 3);
        push_pull(forest, *scene, none, b);
        for (const Element &e : forest.elements)
            for (int k = 0; k < order * order; ++k)
                EXPECT_LT((b.row(e.first + k).transpose().array() - (k == 0 ? glow : Rgb::Zero())).abs().maxCoeff(),
                          1e-12);
    }
}

} // namespace
} // namespace penumbra
