// What the filter microscope shows, against filters integrated anew from the two bases' functions.
#include "iteration/split_filters.h"

#include "geometry/convex_pieces.h"
#include "iteration/solver.h"
#include "iteration/state.h"
#include "reference/faces.h"

#include <boost/math/quadrature/gauss.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace penumbra {
namespace {

using Gauss = boost::math::quadrature::gauss<double, 30>;

template <class Visit>
void over_interval(double low, double high, const Visit &visit) {
    for (std::size_t i = 0; i < Gauss::abscissa().size(); ++i)
        for (const double sign : {-1.0, 1.0})
            visit(low + (high - low) * (1 + sign * Gauss::abscissa()[i]) / 2, (high - low) * Gauss::weights()[i] / 2);
}

struct Integrals {
    Eigen::MatrixXd push, pull;
    double share = 0;
};

/// Over the polygon's triangles, in the plane.
Integrals planar_integrals(const ElementBasis &element, const ElementBasis &piece) {
    Eigen::MatrixXd products = Eigen::MatrixXd::Zero(piece.n_functions(), element.n_functions());
    const Polygon outline = piece.outline();
    for (std::size_t k = 1; k + 1 < outline.size(); ++k) {
        const Vec2 a = outline[0], b = outline[k], c = outline[k + 1];
        const double doubled = cross(b - a, c - a);
        over_interval(0, 1, [&](double s, double ws) {
            over_interval(0, 1, [&](double t, double wt) {
                const Vec2 p = a + s * (b - a) + s * t * (c - b);
                products += ws * wt * s * doubled * piece.evaluate(p) * element.evaluate(p).transpose();
            });
        });
    }
    return {products / piece.area(), products.transpose() / element.area(), piece.area() / element.area()};
}

/// Push over the piece's parameter square. Pull over the element's, with the piece's functions 0 outside the piece: on
/// a line of constant v (or u, where that is a side without length) the piece is one interval.
Integrals parametric_integrals(const ElementBasis &element, const ElementBasis &piece) {
    Integrals out{Eigen::MatrixXd::Zero(piece.n_functions(), element.n_functions()),
                  Eigen::MatrixXd::Zero(element.n_functions(), piece.n_functions()), 0};
    over_interval(0, 1, [&](double u, double wu) {
        over_interval(0, 1, [&](double v, double wv) {
            const Vec2 p = piece.quad()->at(u, v);
            out.push += wu * wv * piece.evaluate(p) * element.evaluate(p).transpose();
        });
    });
    const BilinearQuad &quad = *element.quad();
    const auto &c = quad.corners;
    const bool lines_of_u = c[0] == c[1] || c[2] == c[3]; // u is lost there: lines of constant u end in the corner
    const auto at = [&](double line, double along) { return lines_of_u ? quad.at(line, along) : quad.at(along, line); };
    std::vector<double> breaks;
    for (const Vec2 &corner : piece.outline()) {
        const Vec2 uv = quad.inverse(corner);
        if (std::ranges::none_of(std::array{0, 1, 2, 3}, [&](int k) { // not the corner at which all lines meet
                const auto i = static_cast<std::size_t>(k), j = (i + 1) % 4;
                return c[i] == c[j] && corner == c[i];
            }))
            breaks.push_back(std::clamp(lines_of_u ? uv.x() : uv.y(), 0.0, 1.0));
    }
    std::ranges::sort(breaks);
    for (std::size_t k = 0; k + 1 < breaks.size(); ++k)
        over_interval(breaks[k], breaks[k + 1], [&](double line, double w) {
            double low = 0, high = 1;
            for (const HalfPlane &h : half_planes(piece.outline())) {
                const double a = h.value(at(line, 0)), b = h.value(at(line, 1));
                if (a < b)
                    low = std::max(low, a / (a - b));
                else if (b < a)
                    high = std::min(high, a / (a - b));
            }
            if (low >= high)
                return;
            over_interval(low, high, [&](double along, double wa) {
                const Vec2 p = at(line, along);
                out.pull += w * wa * element.evaluate(p) * piece.evaluate(p).transpose();
                out.share += w * wa;
            });
        });
    return out;
}

double largest(const Eigen::MatrixXd &m) { return m.cwiseAbs().maxCoeff(); }

/// A floor that is no parallelogram, a triangular wall, a lamp, and a slanted blocker: cuts of all kinds.
struct Solved {
    std::shared_ptr<const State> state;
    std::shared_ptr<const Snapshot> snapshot;

    Solved(BasisFamily basis, int order, Strategy strategy = Strategy::discontinuity_wavelet) {
        const auto scene = reference::scene_of(
            {{{{0, 0, 0}, {1, 0, 0}, {0.9, 0.8, 0}, {0.1, 1, 0}}},
             {{{0, 1.2, 0}, {1, 1.2, 0}, {0.4, 1.2, 0.9}}},
             {{{0.3, 0.3, 1}, {0.3, 0.6, 1}, {0.6, 0.6, 1}, {0.6, 0.3, 1}}, Rgb::Zero(), Rgb::Constant(1)},
             {{{0.35, 0.3, 0.4}, {0.6, 0.4, 0.4}, {0.5, 0.7, 0.5}}, Rgb::Zero()}});
        Options options;
        options.basis = basis;
        options.order = order;
        options.strategy = strategy;
        options.threshold = 0.005;
        Solver solver(scene, options);
        for (int k = 0; k < 4; ++k)
            solver.step();
        state = solver.state();
        snapshot = solver.snapshot();
    }
    /// The elements that were split, in the order of snapshot.splits.
    std::vector<const Element *> split_elements() const {
        std::vector<const Element *> found;
        for (const Element &e : state->forest.elements)
            if (!e.leaf())
                found.push_back(&e);
        return found;
    }
};

class SplitFiltersTest : public testing::TestWithParam<std::tuple<BasisFamily, int>> {};

TEST_P(SplitFiltersTest, AreTheIntegralsOfTheFunctions) {
    const auto &[basis, order] = GetParam();
    const Solved solved(basis, order);
    const auto elements = solved.split_elements();
    ASSERT_EQ(elements.size(), solved.snapshot->splits.size());
    int n_cuts = 0;
    for (std::size_t i = 0; i < elements.size(); ++i) {
        const SplitFilters shown = split_filters(*solved.snapshot, static_cast<int>(i));
        const Element &element = *elements[i];
        ASSERT_EQ(static_cast<int>(shown.pieces.size()), element.n_children);
        n_cuts += shown.kind == SplitKind::cut;
        const int n = element.basis.n_functions();
        Eigen::MatrixXd loss = -Eigen::MatrixXd::Identity(n, n);
        for (std::size_t c = 0; c < shown.pieces.size(); ++c) {
            const Element &child = solved.state->forest.elements[element.first_child.at() + c];
            const Integrals own = basis == BasisFamily::planar ? planar_integrals(element.basis, child.basis)
                                                               : parametric_integrals(element.basis, child.basis);
            const PieceFilters &piece = shown.pieces[c];
            const double slack = basis == BasisFamily::planar ? 1e-12 : 1e-7; // rational integrands, 16 points
            EXPECT_LT(largest(piece.push - own.push), slack) << i;
            EXPECT_LT(largest(piece.pull - own.pull), slack) << i;
            EXPECT_NEAR(piece.share, own.share, slack) << i;
            EXPECT_LT(largest(piece.difference - (own.pull - own.share * own.push.transpose())), 4 * slack) << i;
            loss += own.pull * own.push;
        }
        EXPECT_LT(largest(shown.loss - loss), basis == BasisFamily::planar ? 1e-12 : 4e-7) << i;
    }
    EXPECT_GE(n_cuts, 5);
}

INSTANTIATE_TEST_SUITE_P(BothBases, SplitFiltersTest,
                         testing::Combine(testing::Values(BasisFamily::parametric, BasisFamily::planar),
                                          testing::Values(2, 4)),
                         [](const auto &chosen) {
                             return std::string(name(std::get<0>(chosen.param))) + "_order_" +
                                    std::to_string(std::get<1>(chosen.param));
                         });

TEST(SplitFilters, PlanarSplitsKeepTheRelationAndLoseNothing) {
    const Solved solved(BasisFamily::planar, 4);
    std::set<SplitKind> kinds;
    for (std::size_t i = 0; i < solved.snapshot->splits.size(); ++i) {
        const SplitFilters shown = split_filters(*solved.snapshot, static_cast<int>(i));
        kinds.insert(shown.kind);
        for (const PieceFilters &piece : shown.pieces) {
            EXPECT_LE(largest(piece.difference), 1e-12);
            EXPECT_NEAR(piece.share, area(piece.corners) / area(shown.corners), 1e-12);
        }
        EXPECT_LE(largest(shown.loss), 1e-12);
    }
    EXPECT_EQ(kinds, (std::set{SplitKind::uniform, SplitKind::cut}));
}

TEST(SplitFilters, ParametricOnesKeepItForUniformDilationOnly) {
    const Solved uniform(BasisFamily::parametric, 4, Strategy::uniform_wavelet), cuts(BasisFamily::parametric, 4);
    ASSERT_FALSE(uniform.snapshot->splits.empty());
    for (std::size_t i = 0; i < uniform.snapshot->splits.size(); ++i) {
        const SplitFilters shown = split_filters(*uniform.snapshot, static_cast<int>(i));
        ASSERT_EQ(shown.pieces.size(), 4u);
        for (const PieceFilters &piece : shown.pieces) {
            EXPECT_NEAR(piece.share, 0.25, 1e-14); // the paper, below (7)
            EXPECT_LE(largest(piece.difference), 1e-12);
        }
        EXPECT_LE(largest(shown.loss), 1e-12);
    }
    double difference = 0, loss = 0;
    for (std::size_t i = 0; i < cuts.snapshot->splits.size(); ++i) {
        const SplitFilters shown = split_filters(*cuts.snapshot, static_cast<int>(i));
        loss = std::max(loss, largest(shown.loss));
        for (const PieceFilters &piece : shown.pieces)
            difference = std::max(difference, largest(piece.difference));
    }
    EXPECT_GT(difference, 0.05);
    EXPECT_GT(loss, 0.05);
}

TEST(SplitFilters, AStraightCutOfASquareInClosedForm) {
    // The paper's dilation with another factor: u = a u' on the piece, so that N_1 = sqrt(3) (2 a u' - 1) there.
    Snapshot snapshot;
    snapshot.options.order = 2;
    const double a = 0.3;
    const BilinearQuad square{{Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)}},
        low{{Vec2(0, 0), Vec2(a, 0), Vec2(a, 1), Vec2(0, 1)}}, high{{Vec2(a, 0), Vec2(1, 0), Vec2(1, 1), Vec2(a, 1)}};
    SnapshotSplit split{0, SplitKind::cut, square.outline(), {}};
    for (const BilinearQuad &piece : {low, high})
        split.pieces.push_back(
            {piece.outline(), std::make_shared<const TwoScale>(two_scale({2, square}, ElementBasis(2, piece)))});
    snapshot.splits.push_back(split);
    const SplitFilters shown = split_filters(snapshot, 0);
    Eigen::Matrix4d push; // rows and columns: 1, v, u, u v
    push << 1, 0, std::sqrt(3) * (a - 1), 0, 0, 1, 0, std::sqrt(3) * (a - 1), 0, 0, a, 0, 0, 0, 0, a;
    EXPECT_NEAR(shown.pieces[0].share, a, 1e-14);
    EXPECT_LT(largest(shown.pieces[0].push - push), 1e-13);
    EXPECT_LT(largest(shown.pieces[0].pull - a * push.transpose()), 1e-13);
    EXPECT_LT(largest(shown.loss), 1e-13);
}

TEST(SplitFilters, APatchKnowsTheSplitsAboveIt) {
    for (const BasisFamily basis : {BasisFamily::parametric, BasisFamily::planar}) {
        const Solved solved(basis, 2);
        const Snapshot &snapshot = *solved.snapshot;
        std::size_t deepest = 0;
        for (int p = 0; p < static_cast<int>(snapshot.patches.size()); ++p) {
            const SnapshotPatch &patch = snapshot.patches[static_cast<std::size_t>(p)];
            const std::vector<int> above = splits_above(snapshot, p);
            deepest = std::max(deepest, above.size());
            std::vector<Vec2> inner = patch.corners;
            SnapshotPlace place = patch.place;
            for (const int s : above) {
                const SnapshotSplit &split = snapshot.splits[static_cast<std::size_t>(s)];
                EXPECT_EQ(place.split, s);
                EXPECT_EQ(split.surface, patch.surface);
                EXPECT_EQ(split.pieces[static_cast<std::size_t>(place.piece)].corners, inner);
                inner = split.corners;
                place = split.place;
            }
            EXPECT_EQ(place.split, -1);
        }
        EXPECT_GE(deepest, 3u);
    }
}

TEST(SplitFilters, FunctionsAreNamedByTheirDegrees) {
    const double u = 0.83, v = 0.31;
    const auto legendre = [](int n, double x) { return std::sqrt(2 * n + 1) * std::legendre(unsigned(n), 2 * x - 1); };
    const Polygon square{{0, 0}, {1, 0}, {1, 1}, {0, 1}}; // on it both families are products
    for (int order = 1; order <= 4; ++order) {
        const ElementBasis parametric(order, BilinearQuad{{square[0], square[1], square[2], square[3]}}),
            planar(order, PlanarDomain(square));
        const auto check = [&](const ElementBasis &basis, BasisFamily family) {
            QuadraturePoint at{};
            at.position = at.own = Vec2(u, v);
            const BasisValues values = basis.evaluate(at);
            for (int k = 0; k < basis.n_functions(); ++k) {
                const auto [i, j] = function_degrees(family, order, k);
                EXPECT_NEAR(values[k], legendre(i, u) * legendre(j, v), 1e-12) << name(family) << k;
            }
        };
        check(parametric, BasisFamily::parametric);
        check(planar, BasisFamily::planar);
    }
}

} // namespace
} // namespace penumbra
