// The profile's figure against a baseline, and what must not pass for it.
#include "baseline.h"
#include "ssim.h"

#include "plot/plot_picture.h"
#include "plot/profile_sheet.h"
#include "window/offscreen.h"

#include <gtest/gtest.h>

#include <cmath>

namespace penumbra {
namespace {

constexpr int width = 900, height = 620;
constexpr float text = 13;

/// A penumbra from 0.8 to 1.4 of a line of length 2, one solution of steps and one of straight pieces.
ProfileData made_up() {
    ProfileData data;
    data.scene = "made-up";
    data.surface = "floor";
    data.length = 2;
    const auto truth = [](double s) {
        const double t = std::clamp((s - 0.8) / 0.6, 0.0, 1.0);
        return ProfilePoint{s, Rgb::Constant(1 + 3 * t * t * (3 - 2 * t)),
                            Rgb::Constant(t > 0 && t < 1 ? 30 * t * (1 - t) : 0)};
    };
    for (int i = 0; i <= 400; ++i)
        data.exact.push_back(truth(i / 200.0));
    data.curves = {{Strategy::uniform_constant, 1, {}}, {Strategy::discontinuity_wavelet, 4, {}}};
    for (int k = 0; k < 8; ++k) {
        const double low = k / 4.0, high = low + 0.25;
        const Rgb b = truth(0.5 * (low + high)).radiosity;
        data.curves[0].pieces.push_back({k, low, high, {{low, b, Rgb::Zero()}, {high, b, Rgb::Zero()}}});
    }
    const double ends[] = {0, 0.8, 1.1, 1.4, 2};
    for (int k = 0; k < 4; ++k) {
        const ProfilePoint a = truth(ends[k]), b = truth(ends[k + 1]);
        const Rgb slope = (b.radiosity - a.radiosity) / (b.at - a.at);
        data.curves[1].pieces.push_back({k, a.at, b.at, {{a.at, a.radiosity, slope}, {b.at, b.radiosity, slope}}});
    }
    data.crossings = {{0.8, 0, 2}, {1.1, 2, 2}, {1.4, 1, 1}};
    return data;
}

Image figure(const ProfileData &data, Theme theme) {
    const Offscreen context;
    return draw_plot_picture(width, height, text, theme, [&](Canvas &canvas) {
        draw_profile_figure(canvas, {width, height}, data, {text, theme});
    });
}

TEST(GoldenProfile, OnPaper) { expect_golden("profile", figure(made_up(), Theme::light)); }

TEST(GoldenProfile, ControlsFail) {
    ASSERT_TRUE(std::filesystem::exists(baseline("profile")));
    const Image golden = read_png(baseline("profile"));
    const auto likeness = [&](const ProfileData &data) { return ssim(figure(data, Theme::light), golden); };
    ProfileData changed = made_up();
    changed.exact.clear();
    EXPECT_LT(likeness(changed), alike) << "without the truth";
    changed = made_up();
    changed.crossings.clear();
    EXPECT_LT(likeness(changed), alike) << "without crossings";
    changed = made_up();
    auto &pieces = changed.curves[0].pieces;
    pieces.erase(pieces.begin() + std::ssize(pieces) / 2);
    EXPECT_LT(likeness(changed), alike) << "a piece is missing";
    changed = made_up();
    std::swap(changed.curves[0].strategy, changed.curves[1].strategy);
    EXPECT_LT(likeness(changed), alike) << "colours exchanged";
}

TEST(Profile, FiguresAtAPlaceAreThoseOfItsPiece) {
    const ProfileData data = made_up();
    EXPECT_NEAR(channel_mean(point_at(data.exact, 1.1)->radiosity), 2.5, 1e-3);
    EXPECT_FALSE(point_at(data.exact, 2.5));
    EXPECT_NEAR(channel_mean(point_at(data.curves[1], 0.95)->radiosity), 1.75, 1e-12);
    EXPECT_NEAR(channel_mean(point_at(data.curves[1], 0.95)->slope), 5, 1e-12);
    EXPECT_EQ(channel_mean(point_at(data.curves[0], 0.1)->slope), 0);
    const ProfilePlaces places{{{10, 0}, {110, 50}}, {{10, 60}, {110, 90}}, 2};
    EXPECT_NEAR(*places.place({60, 20}), 1, 1e-6);
    EXPECT_FALSE(places.place({5, 20}));
}

} // namespace
} // namespace penumbra
