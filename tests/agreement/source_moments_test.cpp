// The error that source_moments.h and lambert.h allow themselves, against seventy digits, on random points and
// elements. PENUMBRA_RANDOM_PAIRS in the environment asks for more of each sort than a quick run takes.
#include "agreement/random_pairs.h"
#include "reference/point_moments.h"

#include "transport/lambert.h"
#include "transport/source_moments.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>

namespace penumbra {
namespace {

using reference::Digits;

std::uint32_t n_pairs() {
    const char *asked = std::getenv("PENUMBRA_RANDOM_PAIRS");
    return asked ? static_cast<std::uint32_t>(std::atoi(asked)) : 32;
}

double distance_from_outline(const Vec3 &x, const PlaneFrame &source, const Polygon &piece) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < piece.size(); ++i) {
        const Vec3 a = source.to_space(piece[i]), edge = source.to_space(piece[(i + 1) % piece.size()]) - a;
        const double t = std::clamp((x - a).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
        least = std::min(least, (a + t * edge - x).norm());
    }
    return least;
}

/// What doubles lose: the headers' rounding, of T_0 and where N_j is at most 1.
double rounding(const PointAndElement &p, double t0, double width) {
    double reach = (p.x - p.source.origin).norm();
    for (const Vec2 &corner : p.element.outline())
        reach = std::max(reach, corner.norm());
    const Vec2 nearest = nearest_point(p.piece, p.source.to_plane(p.x));
    const double above = std::min(p.source.height(p.x), p.n.dot(p.source.to_space(nearest) - p.x));
    const double away = distance_from_outline(p.x, p.source, p.piece);
    constexpr double eps = std::numeric_limits<double>::epsilon();
    return 16 * eps * reach * (1 + away / width) * std::min(t0 / std::max(above, 1e-300), 1 / away) + eps;
}

double width(const Polygon &convex) { return area(convex) / (2 * radius(convex)); }

double largest_value(const ElementBasis &element) {
    double most = 0;
    for (std::size_t tile = 0; tile < element.n_tiles(); ++tile)
        for (int i = 0; i <= 8; ++i)
            for (int j = 0; j <= 8; ++j)
                most = std::max(most,
                                element.evaluate(element.at_parameters(tile, i / 8.0, j / 8.0)).cwiseAbs().maxCoeff());
    return most;
}

class RandomPairs : public testing::TestWithParam<PairSort> {};

TEST_P(RandomPairs, MomentsToTheAccuracyAskedFor) {
    for (std::uint32_t seed = 0; seed < n_pairs(); ++seed) {
        const PointAndElement p = GetParam().make(seed);
        const auto exact = reference::point_moments(p.x, p.n, p.source, p.element, p.piece);
        const double t0 = reference::exact_lambert(p.x, p.n, p.source, p.piece).convert_to<double>();
        ASSERT_NEAR(exact[0].convert_to<double>(), t0, 1e-14 * t0) << "the reference disagrees with itself, " << seed;
        ConvexPieces pieces;
        pieces.add(p.piece);
        const double most = largest_value(p.element), rounded = rounding(p, t0, width(p.element.outline()));
        for (const double accuracy : {1e-2, 1e-4, 1e-6, 1e-9}) {
            std::vector<double> moments(exact.size());
            Work work;
            source_moments(p.x, p.n, p.source, p.element, pieces, accuracy, moments, work);
            double error = 0;
            for (std::size_t j = 0; j < moments.size(); ++j)
                error = std::max(error, abs(Digits(moments[j]) - exact[j]).convert_to<double>());
            EXPECT_LE(error, (accuracy * t0 + rounded) * most) << "seed " << seed << ", accuracy " << accuracy;
        }
    }
}

TEST_P(RandomPairs, LambertToRounding) {
    for (std::uint32_t seed = 0; seed < 10 * n_pairs(); ++seed) {
        const PointAndElement p = GetParam().make(seed);
        const Digits exact = reference::exact_lambert(p.x, p.n, p.source, p.piece);
        const double error = abs(Digits(lambert(p.x, p.n, p.source, p.piece)) - exact).convert_to<double>();
        EXPECT_LE(error, rounding(p, exact.convert_to<double>(), width(p.piece))) << "seed " << seed;
    }
}

INSTANTIATE_TEST_SUITE_P(Sorts, RandomPairs, testing::ValuesIn(pair_sorts()),
                         [](const auto &sort) { return sort.param.name; });

TEST(PointMoments, TheReferenceDoesNotHangOnItsRule) {
    for (const PairSort &sort : pair_sorts()) {
        const PointAndElement p = sort.make(1);
        const auto coarse = reference::point_moments(p.x, p.n, p.source, p.element, p.piece, 14);
        const auto fine = reference::point_moments(p.x, p.n, p.source, p.element, p.piece, 20);
        for (std::size_t j = 0; j < fine.size(); ++j)
            EXPECT_LT(abs(fine[j] - coarse[j]), 1e-14 * fine[0]) << sort.name << ", moment " << j;
    }
}

TEST(PointMoments, OfATinyPieceAtATrianglesDoubleCorner) {
    // What a blocker leaves of a triangle may be nothing but its double corner, where directions have no digits left.
    const PlaneFrame plane{Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
    const ElementBasis triangle(4, BilinearQuad{{Vec2(1, 0), Vec2(0, 1), Vec2(0, 0), Vec2(0, 0)}});
    for (const double size : {1e-3, 1e-9, 1e-13, 1e-17}) {
        ConvexPieces pieces;
        pieces.add(std::vector<Vec2>{{0, 0}, {size, 0}, {0.5 * size, size}});
        std::vector<double> moments(16);
        Work work;
        source_moments(Vec3(0.3, 0.2, 0.5), -Vec3::UnitZ(), plane, triangle, pieces, 1e-4, moments, work);
        // Area times G; the functions are at most 7 there.
        const double kernel = 0.25 / (std::numbers::pi * 0.38 * 0.38), t0 = kernel * size * size / 2;
        EXPECT_NEAR(moments[0], t0, 5 * size * t0 + 1e-17) << size;
        for (const double t : moments)
            EXPECT_LE(std::abs(t), 7 * (1 + 5 * size) * t0 + 1e-16) << size;
    }
}

} // namespace
} // namespace penumbra
