// Exact orientation where double precision gets the sign wrong.
#include "geometry/predicates.h"

#include <cmath>
#include <gtest/gtest.h>

namespace penumbra {
namespace {

TEST(Predicates, SidesFollowTheNormal) {
    const Vec3 a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);
    EXPECT_EQ(orientation(a, b, c, Vec3(0.2, 0.2, 1e-300)), 1);
    EXPECT_EQ(orientation(a, b, c, Vec3(0.2, 0.2, -1e-300)), -1);
    EXPECT_EQ(orientation(a, b, c, Vec3(0.2, 0.2, 0)), 0);
    EXPECT_EQ(orientation(Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)), 1);
}

TEST(Predicates, ExactWhereRoundingIsNot) {
    // p = (0.5 + i ulp, 0.5 + j ulp) against the diagonal through (12, 12) and (24, 24): left of it when j > i (Kettner
    // et al. 2008 show how naive evaluation scatters the signs).
    const double ulp = std::ldexp(1.0, -53);
    for (int i = 0; i < 32; ++i)
        for (int j = 0; j < 32; ++j) {
            const double x = 0.5 + i * 2 * ulp, y = 0.5 + j * 2 * ulp;
            const int expected = (j > i) - (j < i);
            EXPECT_EQ(orientation(Vec2(12, 12), Vec2(24, 24), Vec2(x, y)), expected) << i << ' ' << j;
            EXPECT_EQ(orientation(Vec3(12, 12, -7), Vec3(24, 24, -7), Vec3(13, 13, 5), Vec3(x, y, 3)), -expected);
        }
}

} // namespace
} // namespace penumbra
