// The scale for signed values: even-handed, and told apart by colour-blind people.
#include "render/diverging.h"

#include <gtest/gtest.h>

#include <cmath>

namespace penumbra {
namespace {

double linear(double s) { return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4); }
glm::dvec3 linear(const glm::dvec3 &c) { return {linear(c.x), linear(c.y), linear(c.z)}; }

/// CIE lightness.
double lightness(const glm::dvec3 &c) {
    const double y = glm::dot(linear(c), glm::dvec3(0.2126, 0.7152, 0.0722));
    return y > 0.008856 ? 116 * std::cbrt(y) - 16 : 903.3 * y;
}

TEST(Diverging, NeutralAtZeroAndDarkerOnEitherSide) {
    const glm::dvec3 middle = diverging(0);
    EXPECT_GT(lightness(middle), 88);
    EXPECT_LT(std::max({middle.x, middle.y, middle.z}) - std::min({middle.x, middle.y, middle.z}), 0.06);
    for (const double side : {-1.0, 1.0})
        for (double t = 0; t < 0.999; t += 0.01)
            EXPECT_LT(lightness(diverging(side * (t + 0.01))), lightness(diverging(side * t))) << side * t;
    for (double t = 0.05; t <= 1; t += 0.05) // as much for -t as for t
        EXPECT_NEAR(lightness(diverging(t)), lightness(diverging(-t)), 11) << t;
    EXPECT_EQ(diverging(3), diverging(1));
    EXPECT_EQ(diverging(-3), diverging(-1));
}

TEST(Diverging, ColourBlindPeopleTellTheSidesApart) {
    // Red and green confused: Machado, Oliveira & Fernandes (2009), severity 1, on linear RGB.
    const glm::dmat3 protan(0.152286, 0.114503, -0.003882, 1.052583, 0.786281, -0.048116, -0.204868, 0.099216,
                            1.051998),
        deutan(0.367322, 0.280085, -0.011820, 0.860646, 0.672501, 0.042940, -0.227968, 0.047413, 0.968881);
    for (const glm::dmat3 &seen : {glm::dmat3(1), protan, deutan})
        for (double t = 0.1; t <= 1; t += 0.1) {
            const glm::dvec3 low = seen * linear(diverging(-t)), high = seen * linear(diverging(t));
            // Blue against yellow, which they keep.
            EXPECT_GT(low.z - (low.x + low.y) / 2, 0.01 + high.z - (high.x + high.y) / 2) << t;
        }
}

} // namespace
} // namespace penumbra
