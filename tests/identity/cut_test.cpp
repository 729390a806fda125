// Cuts tile their parent, and push and pull over them keep the plane's polynomials.
#include "hierarchy/cut.h"
#include "hierarchy/forest.h"
#include "reference/faces.h"

#include <gtest/gtest.h>

#include <Eigen/SVD>

#include <cmath>
#include <random>

namespace penumbra {
namespace {

Forest forest_of(const std::vector<Vec2> &corners, int order) {
    reference::Face face;
    for (const Vec2 &c : corners)
        face.corners.emplace_back(c.x(), c.y(), 0);
    return plant(*reference::scene_of({face}), order);
}

HalfPlane line_through(const Vec2 &a, const Vec2 &b) {
    const Vec2 d = (b - a).normalized();
    return {-d.y(), d.x(), cross(a, d)};
}

/// The sum over all leaves of pull push along the way from the root: what a round trip makes of the root's functions.
Eigen::MatrixXd round_trip(const Forest &forest) {
    const int n = forest.elements[0].basis.n_functions();
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(n, n);
    for_each_leaf(forest, ElementId(0), [&](ElementId leaf) {
        Eigen::MatrixXd down = Eigen::MatrixXd::Identity(n, n), up = down;
        for (ElementId e = leaf; forest[e].parent.valid(); e = forest[e].parent) {
            down = down * forest[e].filters->push;
            up = forest[e].filters->pull * up;
        }
        sum += up * down;
    });
    return sum;
}

/// Coefficients on the element of x^a y^b about its centre in its surface's plane, a + b = degree < order, by solving
/// the interpolation at a grid of parameters (the polynomial lies in the space, so that the fit is exact).
Eigen::MatrixXd plane_polynomials(const Element &e, int order) {
    const int n = 6;
    Eigen::MatrixXd values(n * n, order * order), wanted(n * n, order * (order + 1) / 2);
    const double size = radius(e.basis.outline());
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const Vec2 p = e.basis.quad()->at((i + 0.5) / n, (j + 0.5) / n), q = (p - e.basis.centre()) / size;
            values.row(i * n + j) = e.basis.evaluate(p).transpose();
            int column = 0;
            for (int a = 0; a < order; ++a)
                for (int b = 0; a + b < order; ++b)
                    wanted(i * n + j, column++) = std::pow(q.x(), a) * std::pow(q.y(), b);
        }
    return values.jacobiSvd(Eigen::ComputeThinU | Eigen::ComputeThinV).solve(wanted);
}

/// Two points of the outline of a quad: `from` along one side, `to` along another.
Vec2 on_side(const std::vector<Vec2> &c, std::size_t side, double t) {
    return c[side] + t * (c[(side + 1) % c.size()] - c[side]);
}

struct Cut {
    const char *name;
    std::vector<Vec2> corners;
    std::size_t from_side;
    double from;
    std::size_t to_side;
    double to;
};

std::vector<Cut> all_cuts() {
    const std::vector<Vec2> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, quad{{0, 0}, {1, 0}, {0.9, 0.7}, {0.2, 1.1}},
        triangle{{0, 0}, {1, 0}, {0.3, 0.8}};
    return {{"square, slanted", square, 0, 0.3, 2, 0.3},
            {"square, steep", square, 0, 0.1, 2, 0.1},
            {"quad, slanted", quad, 0, 0.3, 2, 0.3},
            {"quad, other sides", quad, 1, 0.2, 3, 0.6},
            {"square, neighbouring sides", square, 0, 0.4, 1, 0.7},
            {"quad, neighbouring sides", quad, 2, 0.5, 3, 0.4},
            {"square, diagonal", square, 0, 0, 2, 0},
            {"square, corner to side", square, 0, 0, 1, 0.5},
            {"triangle", triangle, 0, 0.4, 1, 0.6},
            {"triangle, from a corner", triangle, 0, 0, 1, 0.3},
            {"quad, close to a corner", quad, 0, 0.98, 1, 0.03}};
}

Forest cut_forest(const Cut &c, int order) {
    Forest forest = forest_of(c.corners, order);
    // Through the solver's frame: the plane of z = 0 is scaled and may be turned.
    const BilinearQuad &quad = *forest.elements[0].basis.quad();
    std::vector<Vec2> corners = quad.outline();
    const auto plan = plan_cut(forest.elements[0],
                               line_through(on_side(corners, c.from_side, c.from), on_side(corners, c.to_side, c.to)));
    EXPECT_TRUE(plan.has_value()) << c.name;
    if (plan)
        cut(forest, ElementId(0), *plan, 1);
    return forest;
}

TEST(Cuts, ChildrenTileTheirParent) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform;
    for (const Cut &c : all_cuts()) {
        const Forest forest = cut_forest(c, 2);
        for (const Element &e : forest.elements) {
            if (e.leaf())
                continue;
            double sum = 0;
            for (int k = 0; k < e.n_children; ++k)
                sum += forest.elements[e.first_child.at() + static_cast<std::size_t>(k)].basis.area();
            EXPECT_NEAR(sum / e.basis.area(), 1, 1e-12) << c.name;
        }
        // No gap and no overlap: a random point lies in one leaf.
        for (int k = 0; k < 2000; ++k) {
            const Vec2 p = forest.elements[0].basis.quad()->at(uniform(random), uniform(random));
            int n_inside = 0;
            for_each_leaf(forest, ElementId(0), [&](ElementId leaf) {
                const Polygon outline = forest[leaf].basis.outline();
                bool in = true;
                for (std::size_t i = 0; i < outline.size(); ++i)
                    in = in && cross(outline[(i + 1) % outline.size()] - outline[i], p - outline[i]) > 0;
                n_inside += in;
            });
            EXPECT_EQ(n_inside, 1) << c.name;
        }
    }
}

TEST(Cuts, NoLeafCrossesTheLine) {
    for (const Cut &c : all_cuts()) {
        const Forest forest = cut_forest(c, 1);
        const std::vector<Vec2> corners = forest.elements[0].basis.quad()->outline();
        const HalfPlane line = line_through(on_side(corners, c.from_side, c.from), on_side(corners, c.to_side, c.to));
        int n_left = 0, n_right = 0;
        for_each_leaf(forest, ElementId(0), [&](ElementId leaf) {
            double low = 0, high = 0;
            for (const Vec2 &p : forest[leaf].basis.outline()) {
                low = std::min(low, line.value(p));
                high = std::max(high, line.value(p));
            }
            EXPECT_LT(std::min(-low, high), 1e-8) << c.name;
            ++(high > -low ? n_left : n_right);
        });
        EXPECT_GE(n_left, 1) << c.name;
        EXPECT_GE(n_right, 1) << c.name;
    }
}

TEST(Cuts, RoundTripsKeepThePlanesPolynomials) {
    for (const Cut &c : all_cuts())
        for (int order = 1; order <= 4; ++order) {
            const Forest forest = cut_forest(c, order);
            const Eigen::MatrixXd polynomials = plane_polynomials(forest.elements[0], order);
            const Eigen::MatrixXd back = round_trip(forest) * polynomials;
            EXPECT_LT((back - polynomials).cwiseAbs().maxCoeff() / polynomials.cwiseAbs().maxCoeff(), 1e-7)
                << c.name << ", order " << order;
        }
}

/// The sum of pull push over the four children of a uniform split.
Eigen::MatrixXd four_way(const Forest &forest, ElementId parent) {
    const int n = forest[parent].basis.n_functions();
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(n, n);
    for (int c = 0; c < 4; ++c) {
        const TwoScale &filters = *forest[ElementId(forest[parent].first_child.index + c)].filters;
        sum += filters.pull * filters.push;
    }
    return sum;
}

TEST(Cuts, UniformSubdivisionBelowACutUsesThePredefinedFilters) {
    // The paper, end of section 5: after cuts go back to the quad-tree and its filters; a flag tells the levels apart.
    for (const Cut &c : all_cuts())
        for (int order = 1; order <= 4; ++order) {
            Forest forest = cut_forest(c, order);
            std::vector<ElementId> pieces;
            for_each_leaf(forest, ElementId(0), [&](ElementId leaf) { pieces.push_back(leaf); });
            for (const ElementId piece : pieces)
                subdivide(forest, piece, 2);
            EXPECT_EQ(forest.elements[0].split, SplitKind::cut);
            for (const ElementId piece : pieces) {
                EXPECT_EQ(forest[piece].split, SplitKind::uniform) << c.name;
                for (std::size_t k = 0; k < 4; ++k) {
                    const Element &child = forest.elements[forest[piece].first_child.at() + k];
                    EXPECT_EQ(child.filters, uniform_two_scale(order)[k]) << c.name;
                    // And they are the filters of this very child: integrated over it they come out the same.
                    const TwoScale computed = two_scale(forest[piece].basis, child.basis);
                    EXPECT_LT((computed.push - child.filters->push).cwiseAbs().maxCoeff(), 1e-7) << c.name;
                    EXPECT_LT((computed.pull - child.filters->pull).cwiseAbs().maxCoeff(), 1e-7) << c.name;
                }
                const Eigen::MatrixXd trip = four_way(forest, piece);
                EXPECT_LT((trip - Eigen::MatrixXd::Identity(trip.rows(), trip.cols())).cwiseAbs().maxCoeff(), 1e-12);
            }
            const Eigen::MatrixXd polynomials = plane_polynomials(forest.elements[0], order);
            const Eigen::MatrixXd back = round_trip(forest) * polynomials;
            EXPECT_LT((back - polynomials).cwiseAbs().maxCoeff() / polynomials.cwiseAbs().maxCoeff(), 1e-7) << c.name;
        }
}

/// Largest part of a function's own coefficient that a round trip loses.
double loss(const Cut &c, int order) {
    const Forest forest = cut_forest(c, order);
    return (1 - round_trip(forest).diagonal().array()).abs().maxCoeff();
}

TEST(Cuts, SlantedCutsLoseALittleOfTheRest) {
    // DESIGN section 2, M = 4 on a square: up to 0.11 for a cut from 0.3 of one side to 0.7 of the opposite one, up to
    // 0.27 from 0.1 to 0.9. A cut that is not slanted loses nothing.
    const std::vector<Vec2> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    EXPECT_NEAR(loss({"", square, 0, 0.3, 2, 0.3}, 4), 0.1122, 1e-3);
    EXPECT_NEAR(loss({"", square, 0, 0.1, 2, 0.1}, 4), 0.2708, 1e-3);
    EXPECT_LT(loss({"", square, 0, 0.3, 2, 0.7}, 4), 1e-10);
}

} // namespace
} // namespace penumbra
