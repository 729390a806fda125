// Curves that cross an element.
#include "discontinuity/curve_index.h"
#include "discontinuity/merge_curves.h"
#include "hierarchy/cut.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

namespace penumbra {
namespace {

using ::testing::SizeIs;

Curve line(int source, const Vec2 &from, const Vec2 &to, int order = 2) {
    return {CurveKind::ve, order, SurfaceId(source), SurfaceId(0), {}, from, to};
}

const std::vector<SurfaceId> one{SurfaceId(1)}, both{SurfaceId(1), SurfaceId(2)};
const Polygon square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};

TEST(CurveIndex, ClipsToTheElement) {
    const CurveIndex index({line(1, {-1, 0.25}, {0.5, 0.25})}, 2);
    const auto found = index.crossing(SurfaceId(0), square, one);
    ASSERT_THAT(found, SizeIs(1));
    EXPECT_NEAR((found[0].from - Vec2(0, 0.25)).norm(), 0, 1e-15);
    EXPECT_NEAR((found[0].to - Vec2(0.5, 0.25)).norm(), 0, 1e-15);
    EXPECT_THAT(index.crossing(SurfaceId(1), square, one), SizeIs(0));
}

TEST(CurveIndex, LeavesOutBordersAndCornersOnly) {
    const CurveIndex index({line(1, {-1, 1}, {2, 1}), line(1, {-1, 1}, {1, -1}), line(1, {2, 0}, {3, 1})}, 1);
    EXPECT_THAT(index.crossing(SurfaceId(0), square, one), SizeIs(0));
}

TEST(CurveIndex, TakesCoincidentLinesOfTwoSourcesOnceWithTheLowerOrder) {
    const CurveIndex index({line(1, {0.2, 0.5}, {0.6, 0.5}), line(2, {0.9, 0.5}, {0.4, 0.5}, 1)}, 1);
    const auto found = index.crossing(SurfaceId(0), square, both);
    ASSERT_THAT(found, SizeIs(1));
    EXPECT_EQ(found[0].order, 1);
    EXPECT_EQ(found[0].curve, CurveId(1));
    EXPECT_NEAR(std::abs(found[0].to.x() - found[0].from.x()), 0.7, 1e-15);
}

TEST(CurveIndex, ALineOfTwoSourcesIsFoundForEachAlone) {
    const CurveIndex index({line(1, {0.2, 0.5}, {0.6, 0.5}), line(2, {0.9, 0.5}, {0.4, 0.5})}, 1);
    for (const int source : {1, 2}) {
        const std::vector<SurfaceId> alone{SurfaceId(source)};
        const auto found = index.crossing(SurfaceId(0), square, alone);
        ASSERT_THAT(found, SizeIs(1));
        EXPECT_EQ(index.curve(found[0].curve).source, alone[0]);
    }
}

/// A quarter of the circle about the origin from (r, 0) to (0, r): the middle weight is cos 45 degrees.
Curve quarter(double r) {
    Curve arc = line(1, {r, 0}, {0, r});
    const double w = std::sqrt(0.5);
    arc.control = {w * r, w * r, w};
    return arc;
}

/// The largest distance between the true circle's part inside the polygon and the nearest of the chords.
double farthest_from_chords(double r, const Polygon &convex, const std::vector<CurveSegment> &chords) {
    double farthest = 0;
    for (int k = 0; k <= 1000; ++k) {
        const Vec2 p = r * Vec2(std::cos(k * M_PI / 2000), std::sin(k * M_PI / 2000));
        double nearest = 10;
        for (const CurveSegment &s : chords)
            nearest = std::min(nearest, distance(line(1, s.from, s.to), p));
        if (contains(convex, p))
            farthest = std::max(farthest, nearest);
    }
    return farthest;
}

TEST(CurveIndex, AnArcEntersAndLeavesWhereTheCircleMeetsTheElement) {
    // x = 0.5 meets the unit circle at y = sqrt(3)/2; the top, y = 0.8, at x = 0.6.
    const CurveIndex index({quarter(1)}, 1);
    const auto found = index.crossing(SurfaceId(0), {{0.5, 0}, {0.9, 0}, {0.9, 0.8}, {0.5, 0.8}}, one);
    ASSERT_FALSE(found.empty());
    EXPECT_NEAR((found.front().from - Vec2(0.9, std::sqrt(0.19))).norm(), 0, 1e-14);
    EXPECT_NEAR((found.back().to - Vec2(0.6, 0.8)).norm(), 0, 1e-14);
    for (const CurveSegment &s : found) {
        EXPECT_NEAR(s.from.norm(), 1, 1e-14);
        EXPECT_NEAR(s.to.norm(), 1, 1e-14);
    }
}

TEST(CurveIndex, AnArcThatLeavesAndComesBackHasTwoParts) {
    // The square cuts the middle of the arc off: it is inside below the diagonal corner only.
    const CurveIndex index({quarter(1)}, 1);
    const Polygon corner_cut{{0, 0}, {1.1, 0}, {1.1, 0.1}, {0.1, 1.1}, {0, 1.1}};
    for (const CurveSegment &s : index.crossing(SurfaceId(0), corner_cut, one)) {
        EXPECT_LE(s.from.sum(), 1.2 + 1e-12);
        EXPECT_LE(s.to.sum(), 1.2 + 1e-12);
    }
    // x + y = 1.2 on the circle: x = 0.6 +- sqrt(0.14).
    const auto found = index.crossing(SurfaceId(0), corner_cut, one);
    const auto meets = [&](double x) {
        return std::ranges::any_of(found, [&](const CurveSegment &s) {
            const Vec2 p(x, 1.2 - x);
            return (s.from - p).norm() < 1e-13 || (s.to - p).norm() < 1e-13;
        });
    };
    EXPECT_TRUE(meets(0.6 + std::sqrt(0.14)));
    EXPECT_TRUE(meets(0.6 - std::sqrt(0.14)));
}

TEST(CurveIndex, AShallowArcIsOneChordAndADeepOneSeveral) {
    const CurveIndex index({quarter(1)}, 1);
    EXPECT_THAT(index.crossing(SurfaceId(0), {{0.6, 0.6}, {0.8, 0.6}, {0.8, 0.8}, {0.6, 0.8}}, one), SizeIs(1));
    const auto deep = index.crossing(SurfaceId(0), square, one);
    EXPECT_GT(deep.size(), 1u);
    EXPECT_LT(farthest_from_chords(1, square, deep), 0.125 * std::sqrt(0.5));
}

TEST(CurveIndex, AnArcBesideItsOwnChordIsHalved) {
    // What a cut along the chord leaves: the arc enters and leaves through the same side.
    const CurveIndex index({quarter(1)}, 1);
    const Polygon beyond{{1, 0}, {1, 1}, {0, 1}};
    const auto found = index.crossing(SurfaceId(0), beyond, one);
    ASSERT_THAT(found, SizeIs(2));
    const Vec2 shoulder(std::sqrt(0.5), std::sqrt(0.5));
    EXPECT_NEAR((found[0].to - shoulder).norm(), 0, 1e-14);
    EXPECT_NEAR((found[1].from - shoulder).norm(), 0, 1e-14);
    // On the near side of the chord there is nothing of it.
    EXPECT_THAT(index.crossing(SurfaceId(0), {{0, 0}, {1, 0}, {0, 1}}, one), SizeIs(0));
}

/// How deep inside the polygon p lies.
double depth_inside(const Polygon &convex, const Vec2 &p) {
    double depth = 10;
    for (std::size_t i = 0; i < convex.size(); ++i)
        depth = std::min(depth, distance(line(1, convex[i], convex[(i + 1) % convex.size()]), p));
    return depth;
}

TEST(CurveIndex, RoundsOfCutsCloseInOnTheArc) {
    const double r = 0.3;
    const CurveIndex index({quarter(r)}, 1);
    std::vector<Element> leaves(1);
    leaves[0].basis = ElementBasis(1, BilinearQuad{{{{0, 0}, {0.5, 0}, {0.5, 0.5}, {0, 0.5}}}});
    leaves[0].sides.resize(4);
    std::vector<double> gaps;
    for (int round = 0; round < 12; ++round) {
        std::vector<Element> next;
        for (const Element &leaf : leaves) {
            const auto chords = index.crossing(SurfaceId(0), leaf.basis.outline(), one);
            const auto longest = std::ranges::max_element(
                chords, {}, [](const CurveSegment &s) { return (s.to - s.from).norm(); });
            std::optional<CutPlan> plan;
            if (longest != chords.end()) {
                const Vec2 d = (longest->to - longest->from).normalized();
                plan = plan_cut(leaf, {-d.y(), d.x(), cross(longest->from, d)});
            }
            if (!plan) {
                next.push_back(leaf);
                continue;
            }
            for (const ElementBasis &piece : plan->leaves()) {
                next.emplace_back().basis = piece;
                next.back().sides.resize(4);
            }
        }
        leaves = std::move(next);
        // How far the circle still runs inside of a leaf.
        double gap = 0;
        for (int k = 0; k <= 2000; ++k) {
            const Vec2 p = r * Vec2(std::cos(k * M_PI / 4000), std::sin(k * M_PI / 4000));
            for (const Element &leaf : leaves)
                if (contains(leaf.basis.outline(), p))
                    gap = std::max(gap, depth_inside(leaf.basis.outline(), p));
        }
        gaps.push_back(gap);
    }
    EXPECT_GT(gaps.front(), 0.01);
    // Half an arc has a quarter of the sagitta. A leaf beside a cut holds two chords and takes one a round: a quarter
    // every two rounds.
    for (std::size_t k = 2; k < gaps.size(); ++k)
        EXPECT_LT(gaps[k], 0.27 * gaps[k - 2]) << "round " << k;
}

TEST(MergeCurves, AnArcThatRepeatsAnotherIsDroppedAndOthersStay) {
    Curve reversed = quarter(1), weaker = quarter(1), other = quarter(0.5);
    std::swap(reversed.from, reversed.to);
    weaker.order = 1;
    weaker.blockers = {SurfaceId(3)};
    Curve chord = line(1, {1, 0}, {0, 1});
    const auto merged = merge_curves({quarter(1), chord, reversed, other, weaker});
    ASSERT_THAT(merged, SizeIs(3));
    EXPECT_TRUE(merged[0].straight());
    EXPECT_EQ(merged[1].order, 1);
    EXPECT_EQ(merged[1].blockers, weaker.blockers);
    EXPECT_EQ(merged[2].from, other.from);
}

TEST(MergeCurves, ArcsThatShareEndsAndShoulderOnlyStayApart) {
    // (from + 2 control + to) / (2 + 2 w) is the circle's shoulder, but w is not the circle's.
    const double shoulder = std::sqrt(0.5), w = 0.5;
    Curve other = quarter(1);
    other.control = {(1 + w) * shoulder - 0.5, (1 + w) * shoulder - 0.5, w};
    ASSERT_NEAR((point_at(other, 0.5) - point_at(quarter(1), 0.5)).norm(), 0, 1e-15);
    EXPECT_THAT(merge_curves({quarter(1), other}), SizeIs(2));
}

TEST(MergeCurves, JoinsPiecesOfManyLinesInAnyOrder) {
    // 200 lines in all directions, each in five touching pieces that come mixed.
    std::vector<Curve> pieces;
    for (int k = 0; k < 5; ++k)
        for (int i = 0; i < 200; ++i) {
            const double angle = i * M_PI / 200;
            const Vec2 d(std::cos(angle), std::sin(angle)), foot(0.3 * d.y(), -0.2 * d.x());
            const Vec2 a = foot + 0.1 * k * d, b = foot + 0.1 * (k + 1) * d;
            pieces.push_back(k % 2 == 0 ? line(1, a, b) : line(1, b, a));
        }
    const auto merged = merge_curves(pieces);
    ASSERT_THAT(merged, SizeIs(200));
    for (const Curve &c : merged)
        EXPECT_NEAR((c.to - c.from).norm(), 0.5, 1e-12);
}

} // namespace
} // namespace penumbra
