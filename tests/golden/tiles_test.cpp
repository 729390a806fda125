// Pictures in tiles, supersampled, and with a transparent background.
#include "ssim.h"
#include "synthetic.h"

#include "render/picture.h"
#include "window/offscreen.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

namespace penumbra {
namespace {

/// Two panes with lines, dashes, hatches, links, an odd width and words.
PictureSpec rich(int width = 641, int height = 480) {
    PictureSpec spec;
    spec.width = width;
    spec.height = height;
    spec.text = 11;
    spec.panes = {{synthetic::lamp_and_blocker(), "(a)"}, {synthetic::closed_room(), "(b)"}};
    spec.columns = 2;
    spec.look.layers.links = true;
    spec.camera = default_view(*spec.panes[0].snapshot, pane_aspect(spec));
    return spec;
}

struct Difference {
    std::size_t n = 0;        ///< bytes that differ
    int largest = 0;          ///< of a byte
    std::size_t at_seams = 0; ///< of the bytes, those within a pixel of a tile's border
};

Difference difference(const Image &a, const Image &b, int tile) {
    Difference d;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x)
            for (int c = 0; c < 3; ++c) {
                const auto i = static_cast<std::size_t>(3 * (y * a.width + x) + c);
                const int off = std::abs(a.rgb[i] - b.rgb[i]);
                const auto near = [&](int k) { return (k + 1) % tile <= 1; };
                d.n += off > 0;
                d.largest = std::max(d.largest, off);
                d.at_seams += off > 0 && (near(x) || near(a.height - 1 - y));
            }
    return d;
}

/// The driver may round a corner's place to another 256th of a pixel in a tile than in the whole: single samples on edges
/// change, of four a pixel and after blending.
TEST(Tiles, APictureInTilesIsThePicture) {
    const Offscreen context;
    for (const bool light : {false, true}) {
        PictureSpec spec = rich();
        spec.look.theme = light ? Theme::light : Theme::dark;
        const Image whole = draw_picture(spec);
        for (const int tile : {64, 150}) {
            const Image tiled = draw_picture(spec, tile);
            ASSERT_EQ(tiled.rgb.size(), whole.rgb.size());
            EXPECT_GE(ssim(tiled, whole), 0.99999) << tile;
            const Difference d = difference(tiled, whole, tile);
            const double n = static_cast<double>(whole.rgb.size()), seams = 4.0 / tile;
            EXPECT_LT(static_cast<double>(d.n), 2e-3 * n) << tile;
            EXPECT_LE(d.largest, 8) << tile;
            EXPECT_LT(static_cast<double>(d.at_seams), 2e-3 * n * seams + 30) << tile;
            RecordProperty("bytes", static_cast<int>(d.n));
            RecordProperty("largest", d.largest);
        }
    }
}

TEST(Tiles, TheControlFails) {
    const Offscreen context;
    const PictureSpec spec = rich();
    const Image whole = draw_picture(spec);
    PictureSpec moved = spec;
    moved.camera = orbit(spec.camera, 0.002, 0, spec.camera.target); // by half a pixel or so
    EXPECT_GT(static_cast<double>(difference(draw_picture(moved), whole, 64).n),
              2e-3 * static_cast<double>(whole.rgb.size()));
}

/// A side that is longer than any tile; both ends of it are drawn.
TEST(Tiles, ASideOfEightThousandPixels) {
    const Offscreen context;
    PictureSpec spec = rich(8192, 96);
    spec.labels = spec.legend = false;
    spec.camera = default_view(*spec.panes[0].snapshot, pane_aspect(spec));
    for (PicturePane &pane : spec.panes)
        pane.snapshot = spec.panes[0].snapshot;
    const Image image = draw_picture(spec);
    ASSERT_EQ(image.width, 8192);
    ASSERT_EQ(image.rgb.size(), 3u * 8192 * 96);
    // The same in both panes, which begin in different places of their tiles.
    const int pane_width = (8192 - 5) / 2, second = pane_width + 5;
    int alike = 0, drawn = 0;
    for (int y = 0; y < 96; ++y)
        for (int x = 0; x < pane_width; ++x) {
            const auto i = static_cast<std::size_t>(3 * (y * 8192 + x));
            const auto j = static_cast<std::size_t>(3 * (y * 8192 + second + x));
            drawn += image.rgb[i] > 60;
            alike += std::abs(image.rgb[i] - image.rgb[j]) < 8;
        }
    EXPECT_GT(drawn, 500);
    EXPECT_GT(alike, pane_width * 96 * 0.995);
}

/// More samples to a side than the largest viewport has pixels: nowhere does what is drawn move.
TEST(Tiles, MoreSamplesThanAViewportHolds) {
    const Offscreen context;
    PictureSpec spec = rich(8192, 96);
    spec.panes.resize(1);
    spec.columns = 1;
    spec.labels = spec.legend = false;
    spec.look.layers.links = false;
    spec.camera = fit(default_view(*spec.panes[0].snapshot, 1), *spec.panes[0].snapshot, pane_aspect(spec));
    spec.camera.fov_y = 0.5; // a strip of the floor, from side to side
    const Image plain = draw_picture(spec);
    spec.supersample = 3;
    const Image smooth = draw_picture(spec);
    int drawn = 0;
    for (int x0 = 0; x0 < 8192; x0 += 256) {
        double off = 0;
        for (int y = 0; y < 96; ++y)
            for (int x = 3 * x0; x < 3 * (x0 + 256); ++x) {
                const auto i = static_cast<std::size_t>(3 * y * 8192 + x);
                off += std::abs(plain.rgb[i] - smooth.rgb[i]);
                drawn += plain.rgb[i] > 60;
            }
        EXPECT_LT(off / (96 * 256 * 3), 4) << "from column " << x0;
    }
    EXPECT_GT(drawn, 8192 * 96);
}

double light(double byte) {
    const double v = byte / 255;
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}
double byte_of(double l) { return 255 * (l <= 0.0031308 ? 12.92 * l : 1.055 * std::pow(l, 1 / 2.4) - 0.055); }

/// Against the mean of a picture that is drawn three times larger, taken here.
TEST(Supersampling, IsTheMeanOfTheLight) {
    const Offscreen context;
    constexpr int n = 3;
    PictureSpec spec = rich(300, 240), large = rich(900, 720);
    large.text = n * spec.text;
    large.camera = spec.camera;
    spec.supersample = n;
    const Image drawn = draw_picture(spec), in_tiles = draw_picture(spec, 100), by = draw_picture(large);
    ASSERT_EQ(drawn.width, 300);
    int largest = 0;
    std::size_t off_in_tiles = 0, off_by_bytes = 0;
    for (int y = 0; y < 240; ++y)
        for (int x = 0; x < 300; ++x)
            for (int c = 0; c < 3; ++c) {
                double sum = 0, bytes = 0;
                for (int k = 0; k < n * n; ++k) {
                    const double b = by.rgb[static_cast<std::size_t>(3 * ((n * y + k / n) * 900 + n * x + k % n) + c)];
                    sum += light(b) / (n * n);
                    bytes += b / (n * n);
                }
                const auto i = static_cast<std::size_t>(3 * (300 * y + x) + c);
                largest = std::max(largest, std::abs(drawn.rgb[i] - static_cast<int>(std::lround(byte_of(sum)))));
                off_by_bytes += std::abs(drawn.rgb[i] - bytes) > 1.5;
                off_in_tiles += std::abs(drawn.rgb[i] - in_tiles.rgb[i]) > 1;
            }
    EXPECT_LE(largest, 1);
    EXPECT_LT(off_in_tiles, drawn.rgb.size() / 200);
    EXPECT_GT(off_by_bytes, drawn.rgb.size() / 50) << "the control: the mean of sRGB is another";
}

/// Words and lines are as large as without; the picture is alike but for its edges.
TEST(Supersampling, KeepsTheSizeOfWordsAndLines) {
    const Offscreen context;
    PictureSpec spec = rich();
    const Image plain = draw_picture(spec);
    spec.supersample = 2;
    const Image smooth = draw_picture(spec);
    ASSERT_EQ(plain.width, smooth.width);
    EXPECT_GT(ssim(plain, smooth), 0.8);
    EXPECT_LT(ssim(plain, smooth), 0.9999);
}

/// Laid over the background of the theme it is the picture that is not transparent: alpha was taken out of the colours,
/// and taken out once.
TEST(Transparent, OverTheBackgroundItIsTheOpaquePicture) {
    const Offscreen context;
    for (const Theme theme : {Theme::dark, Theme::light}) {
        PictureSpec spec = rich();
        spec.look.theme = theme;
        spec.panes[1].snapshot = spec.panes[0].snapshot; // else footnotes stand in the panes, on plates over what is drawn
        const Image opaque = draw_picture(spec);
        EXPECT_TRUE(opaque.alpha.empty());
        spec.look.transparent = true;
        const Image clear = draw_picture(spec);
        ASSERT_EQ(clear.alpha.size(), static_cast<std::size_t>(spec.width * spec.height));
        const glm::vec4 background = background_colour(theme);
        int largest = 0;
        std::size_t n_clear = 0, n_between = 0, n_full = 0;
        for (std::size_t p = 0; p < clear.alpha.size(); ++p) {
            const double a = clear.alpha[p] / 255.0;
            n_clear += clear.alpha[p] == 0;
            n_full += clear.alpha[p] == 255;
            n_between += clear.alpha[p] > 0 && clear.alpha[p] < 255;
            for (int c = 0; c < 3; ++c) {
                const double over = a * clear.rgb[3 * p + static_cast<std::size_t>(c)] +
                                    (1 - a) * 255 * static_cast<double>(background[c]);
                largest = std::max(largest, static_cast<int>(std::lround(
                                                std::abs(over - opaque.rgb[3 * p + static_cast<std::size_t>(c)]))));
            }
        }
        EXPECT_LE(largest, 3);
        EXPECT_GT(n_clear, clear.alpha.size() / 20);
        EXPECT_GT(n_full, clear.alpha.size() / 20);
        EXPECT_GT(n_between, 1000u); // edges, glass, plates
    }
}

/// Words can be read over any colour: behind them is a plate.
TEST(Transparent, WordsStandOnPlates) {
    const Offscreen context;
    PictureSpec spec = rich();
    spec.look.transparent = true;
    const auto alpha_at = [](const Image &image, int x, int y) {
        return image.alpha[static_cast<std::size_t>(y * image.width + x)];
    };
    const Image with = draw_picture(spec);
    EXPECT_GE(alpha_at(with, 160, 2), 200) << "over the first pane";
    EXPECT_GE(alpha_at(with, 320, 470), 200) << "the legend";
    spec.labels = spec.legend = false;
    const Image without = draw_picture(spec);
    EXPECT_EQ(alpha_at(without, 2, 2), 0);
    EXPECT_EQ(alpha_at(without, 2, 477), 0);
}

TEST(Transparent, SupersampledEdgesHaveTheirOwnColour) {
    const Offscreen context;
    PictureSpec spec = rich(320, 240);
    spec.look.transparent = true;
    spec.look.layers = {false, false, false};
    spec.labels = spec.legend = false;
    spec.supersample = 4;
    const Image image = draw_picture(spec);
    // No dark fringe: where little covers a pixel its colour is that of what covers it, never darker than all there is.
    int darkest_full = 255, darkest_edge = 255;
    for (std::size_t p = 0; p < image.alpha.size(); ++p) {
        const int brightness = std::max({image.rgb[3 * p], image.rgb[3 * p + 1], image.rgb[3 * p + 2]});
        if (image.alpha[p] == 255)
            darkest_full = std::min(darkest_full, brightness);
        else if (image.alpha[p] >= 16)
            darkest_edge = std::min(darkest_edge, brightness);
    }
    EXPECT_GE(darkest_edge, darkest_full - 6);
}

} // namespace
} // namespace penumbra
