// Polygons that rounding has left without area.
#include "geometry/polygon.h"

#include <gtest/gtest.h>

namespace penumbra {
namespace {

TEST(NearestPoint, OfATriangleIsItselfInsideAndOnTheBorderOutside) {
    const Polygon triangle{{0, 0}, {2, 0}, {0, 2}};
    EXPECT_EQ(nearest_point(triangle, {0.5, 0.25}), Vec2(0.5, 0.25));
    EXPECT_EQ(nearest_point(triangle, {1, -3}), Vec2(1, 0));
    EXPECT_LT((nearest_point(triangle, {2, 2}) - Vec2(1, 1)).norm(), 1e-15);
}

TEST(NearestPoint, OfASegmentIsAnEndBeyondTheEnds) {
    const Polygon segment{{0, 0}, {2, 1}, {2, 1}};
    EXPECT_EQ(nearest_point(segment, {4, 2}), Vec2(2, 1));
    EXPECT_EQ(nearest_point(segment, {-2, -1}), Vec2(0, 0));
    EXPECT_EQ(nearest_point(segment, {1, 0.5}), Vec2(1, 0.5));
}

TEST(NearestPoint, OfASliverThatClippingLeftStaysOnIt) {
    // Two units in the last place wide; the point lies on its line, ten lengths away (bundled scene table at a tolerance
    // of 0.003: radiosity was not finite).
    const Polygon sliver{{0.0098853360947840502, -0.012915800265902284},
                         {0, -0.0053033122994569021},
                         {0, -0.005303312299456903}};
    const Vec2 nearest = nearest_point(sliver, {0.11711982958989439, -0.095494812602176932});
    EXPECT_LT((nearest - sliver[0]).norm(), 1e-15);
}

} // namespace
} // namespace penumbra
