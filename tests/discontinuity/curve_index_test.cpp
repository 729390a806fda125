// Curves that cross an element.
#include "discontinuity/curve_index.h"

#include <gmock/gmock.h>

namespace penumbra {
namespace {

using ::testing::SizeIs;

Curve line(int source, const Vec2 &from, const Vec2 &to, int order = 2) {
    return {CurveKind::ve, order, SurfaceId(source), SurfaceId(0), {}, from, to};
}

const Polygon square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};

TEST(CurveIndex, ClipsToTheElement) {
    const CurveIndex index({line(1, {-1, 0.25}, {0.5, 0.25})}, 2);
    const auto found = index.crossing(SurfaceId(0), square);
    ASSERT_THAT(found, SizeIs(1));
    EXPECT_NEAR((found[0].from - Vec2(0, 0.25)).norm(), 0, 1e-15);
    EXPECT_NEAR((found[0].to - Vec2(0.5, 0.25)).norm(), 0, 1e-15);
    EXPECT_THAT(index.crossing(SurfaceId(1), square), SizeIs(0));
}

TEST(CurveIndex, LeavesOutBordersAndCornersOnly) {
    const CurveIndex index({line(1, {-1, 1}, {2, 1}), line(1, {-1, 1}, {1, -1}), line(1, {2, 0}, {3, 1})}, 1);
    EXPECT_THAT(index.crossing(SurfaceId(0), square), SizeIs(0));
}

TEST(CurveIndex, TakesCoincidentLinesOfTwoSourcesOnceWithTheLowerOrder) {
    const CurveIndex index({line(1, {0.2, 0.5}, {0.6, 0.5}), line(2, {0.9, 0.5}, {0.4, 0.5}, 1)}, 1);
    const auto found = index.crossing(SurfaceId(0), square);
    ASSERT_THAT(found, SizeIs(1));
    EXPECT_EQ(found[0].order, 1);
    EXPECT_EQ(found[0].curve, CurveId(1));
    EXPECT_NEAR(std::abs(found[0].to.x() - found[0].from.x()), 0.7, 1e-15);
}

} // namespace
} // namespace penumbra
