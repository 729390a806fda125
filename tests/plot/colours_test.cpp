// The strategies' colours are told apart by people with each kind of colour blindness, and stand out from the ground.
#include "plot/strategy_style.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace penumbra {
namespace {

glm::dvec3 linear(const glm::vec4 &c) {
    glm::dvec3 out;
    for (int k = 0; k < 3; ++k)
        out[k] = c[k] <= 0.04045f ? c[k] / 12.92 : std::pow((c[k] + 0.055) / 1.055, 2.4);
    return out;
}

/// Machado, Oliveira & Fernandes 2009, severity 1, on linear sRGB; row by row.
constexpr double nothing[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
constexpr double protan[9] = {0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116, 1.051998};
constexpr double deutan[9] = {0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820, 0.042940, 0.968881};
constexpr double tritan[9] = {1.255528, -0.076749, -0.178779, -0.078411, 0.930809, 0.147602, 0.004733, 0.691367, 0.303900};

glm::dvec3 seen(const glm::dvec3 &c, const double (&m)[9]) {
    glm::dvec3 out;
    for (int k = 0; k < 3; ++k)
        out[k] = std::clamp(m[3 * k] * c.x + m[3 * k + 1] * c.y + m[3 * k + 2] * c.z, 0., 1.);
    return out;
}

/// CIE Lab, D65.
glm::dvec3 lab(const glm::dvec3 &c) {
    const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16. / 116; };
    const double x = f((0.4124 * c.x + 0.3576 * c.y + 0.1805 * c.z) / 0.9505),
                 y = f(0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z),
                 z = f((0.0193 * c.x + 0.1192 * c.y + 0.9505 * c.z) / 1.089);
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

double difference(const glm::vec4 &a, const glm::vec4 &b, const double (&blindness)[9]) {
    return glm::distance(lab(seen(linear(a), blindness)), lab(seen(linear(b), blindness)));
}

constexpr double told_apart = 20; // of thin lines; of areas side by side 2 would do

TEST(StrategyColours, AreToldApartByEverybody) {
    for (const Theme theme : {Theme::light, Theme::dark})
        for (const auto *blindness : {&nothing, &protan, &deutan, &tritan})
            for (const Strategy a : all_strategies)
                for (const Strategy b : all_strategies) {
                    const double d = difference(strategy_colour(a, theme), strategy_colour(b, theme), *blindness);
                    EXPECT_TRUE(a == b || d > told_apart) << name(a) << " and " << name(b) << ": " << d;
                }
}

TEST(StrategyColours, TheMeasureFindsRedAndGreenOfOneLightness) {
    const glm::vec4 red(0.80f, 0.35f, 0.20f, 1), green(0.45f, 0.50f, 0.20f, 1);
    EXPECT_GT(difference(red, green, nothing), told_apart);
    EXPECT_LT(difference(red, green, deutan), told_apart);
}

TEST(StrategyColours, StandOutFromTheGround) {
    const auto luminance = [](const glm::vec4 &c) {
        const glm::dvec3 l = linear(c);
        return 0.2126 * l.x + 0.7152 * l.y + 0.0722 * l.z;
    };
    for (const Theme theme : {Theme::light, Theme::dark})
        for (const Strategy s : all_strategies) {
            const double a = luminance(strategy_colour(s, theme)), b = luminance(background_colour(theme));
            const double contrast = (std::max(a, b) + 0.05) / (std::min(a, b) + 0.05);
            EXPECT_GT(contrast, 3) << name(s) << ": what WCAG asks of graphics";
        }
}

TEST(StrategyMarkers, AreAllDifferentAndNoneIsTheCrossOfARunThatWasStopped) {
    std::set<PlotMarker> shapes{PlotMarker::cross};
    for (const Strategy s : all_strategies)
        EXPECT_TRUE(shapes.insert(strategy_marker(s)).second) << name(s);
}

} // namespace
} // namespace penumbra
