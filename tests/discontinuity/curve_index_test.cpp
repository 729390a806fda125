// Curves that cross an element.
#include "discontinuity/curve_index.h"

#include <gmock/gmock.h>

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

} // namespace
} // namespace penumbra
