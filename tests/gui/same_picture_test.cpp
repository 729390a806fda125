// The window and the command line draw one picture: the panes as they stand on the screen, read from the display's server,
// against `penumbra render` of the state that the window saves. Words stand over the window's panes and beside the command
// line's, so the strips of a pane that hold them are left out.
#include "gui/session.h"

#include "capture.h"
#include "golden/ssim.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace penumbra::gui {
namespace {

namespace fs = std::filesystem;

constexpr double alike = 0.999;
constexpr int words_above = 64, words_below = 30; ///< of a pane: its label, and what the label says at its foot [pixels]

Image cut_out(int x0, int y0, int width, int height, const auto &colour_at) {
    Image image{width, height, {}, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (const std::uint8_t channel : colour_at(x0 + x, y0 + y))
                image.rgb.push_back(channel);
    return image;
}

Image of_screen(const Screenshot &shot, const Box &box) {
    return cut_out(box.x, box.y, box.width, box.height, [&](int x, int y) { return shot.at(x, y); });
}

Image of_picture(const Image &image, const Box &box) {
    return cut_out(box.x, box.y, box.width, box.height, [&](int x, int y) {
        const std::uint8_t *rgb = &image.rgb[3 * static_cast<std::size_t>(y * image.width + x)];
        return Colour{rgb[0], rgb[1], rgb[2]};
    });
}

Box without_words(Box pane) { return {pane.x, pane.y + words_above, pane.width, pane.height - words_above - words_below}; }

/// Between the panes of a picture: half its text's height, which is a 42nd of the picture's, or a 60th of its width.
struct Sheet {
    int columns, rows, width = 0, height = 0, gap = 0;

    Sheet(int n_panes, const Box &pane) : columns(n_panes > 1 ? 2 : 1), rows(n_panes > 2 ? 2 : 1) {
        for (int i = 0; i < 5; ++i) {
            width = columns * pane.width + (columns - 1) * gap;
            height = rows * pane.height + (rows - 1) * gap;
            const double text = std::max(11.0, std::round(std::min(width / (columns > 1 ? 60.0 : 54.0), height / 42.0)));
            EXPECT_EQ(text, 15) << "lines are as wide as the window's where text is as high as there";
            gap = n_panes > 1 ? static_cast<int>(text / 2) : 0;
        }
    }
    Box pane(int i, const Box &size) const {
        return {i % columns * (size.width + gap), i / columns * (size.height + gap), size.width, size.height};
    }
};

class SamePicture : public testing::Test {
protected:
    Session session{{"figure-4", "--threshold", "0.03"}, 1280, 630};

    void SetUp() override {
        session.resize(1280, 630);
        session.key("End");
        session.wait_until("the end", [](const Json &s) { return s["converged"] == true && !s["busy"]; });
        session.key("g");   // no legend
        session.key("F11"); // no panels
        session.key("n");   // what is new does not stand out
        session.settled();
    }

    Image rendered(const Sheet &sheet) {
        const Json before = session.settled();
        session.key("ctrl+s");
        const Json after = session.wait_until("a saved state", [&](const Json &s) { return s["saved"] != before["saved"]; });
        const fs::path png = session.home() / "picture.png";
        output_of({PENUMBRA_PROGRAM, "render", after["saved"].get<std::string>(), "-q", "--no-labels", "--no-legend", "--size",
                   std::to_string(sheet.width) + "x" + std::to_string(sheet.height), "-o", png.string()},
                  {{"DISPLAY", ""}, {"HOME", session.home().string()}});
        return read_png(png);
    }

    /// The least of all panes.
    double likeness(int n_panes) {
        const Box pane = session.widget("pane 0");
        const Sheet sheet(n_panes, pane);
        const Image picture = rendered(sheet);
        session.move({1, 1});
        session.settled();
        const Screenshot shot = session.shot();
        double least = 1;
        for (int i = 0; i < n_panes; ++i) {
            const Image seen = of_screen(shot, without_words(session.widget("pane " + std::to_string(i)))),
                        drawn = of_picture(picture, without_words(sheet.pane(i, pane)));
            const double one = ssim(seen, drawn);
            least = std::min(least, one);
            if (one < alike) { // to be looked at
                write_png(fs::path(testing::TempDir()) / "pane-seen.png", seen);
                write_png(fs::path(testing::TempDir()) / "pane-drawn.png", drawn);
            }
        }
        return least;
    }

    /// Keys that lead to it, and back.
    void look(const std::string &name, const std::vector<std::string> &keys, int n_panes) {
        SCOPED_TRACE(name + ", " + std::to_string(n_panes) + " panes");
        for (const std::string &key : keys)
            session.key(key);
        session.settled();
        EXPECT_GE(likeness(n_panes), alike);
        for (auto key = keys.rbegin(); key != keys.rend(); ++key)
            session.key(*key);
        session.settled();
    }

    void all_looks(int n_panes) {
        look("mesh and curves", {}, n_panes);
        look("links", {"l"}, n_panes);
        look("false colour", {"c"}, n_panes);
        look("errors", {"x"}, n_panes);
        look("light", {"shift+b"}, n_panes);
        look("no lines", {"m", "d"}, n_panes);
    }
};

TEST_F(SamePicture, OfOnePane) { all_looks(1); }

TEST_F(SamePicture, OfTwoPanes) {
    session.key("ctrl+2");
    session.key("End"); // of the other strategy, too
    session.wait_until("two", [](const Json &s) { return s["panes"].size() == 2 && s["converged"] == true && !s["busy"]; });
    all_looks(2);
}

TEST_F(SamePicture, OfFourPanes) {
    session.key("ctrl+4");
    session.key("End");
    session.wait_until("four", [](const Json &s) { return s["panes"].size() == 4 && s["converged"] == true && !s["busy"]; });
    all_looks(4);
}

/// The measure sees what a look changes: a layer, half a stop of exposure.
TEST_F(SamePicture, AnotherPictureIsNotAlike) {
    session.key("1"); // many patches
    session.key("End");
    session.wait_until("the end", [](const Json &s) { return s["panes"][0]["patches"] > 100 && s["converged"] == true && !s["busy"]; });
    const Box pane = session.widget("pane 0");
    const Sheet sheet(1, pane);
    const Image picture = rendered(sheet);
    for (const char *key : {"m", "d", "e"}) {
        session.key(key);
        session.settled();
        session.move({1, 1});
        session.settled();
        EXPECT_LT(ssim(of_screen(session.shot(), without_words(pane)), of_picture(picture, without_words(sheet.pane(0, pane)))), alike)
            << key;
        session.key(key == std::string("e") ? "shift+e" : key);
    }
}

/// Rows of squares of two grey values; each window of 8 by 8 holds as many of both.
Image chequered(std::uint8_t even, std::uint8_t odd) {
    Image image{64, 48, {}, {}};
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            image.rgb.insert(image.rgb.end(), 3, (x / 2 + y / 2) % 2 == 0 ? even : odd);
    return image;
}

/// Wang, Bovik, Sheikh & Simoncelli 2004, equation 13: K1 = 0.01, K2 = 0.03, L = 255.
TEST(Ssim, IsTheClosedForm) {
    const double c1 = 6.5025, c2 = 58.5225, mean = 100, deviation = 30;
    const Image a = chequered(130, 70);
    EXPECT_DOUBLE_EQ(ssim(a, a), 1);
    // Brighter by 20: contrast and structure are the same.
    EXPECT_NEAR(ssim(a, chequered(150, 90)), (2 * mean * 120 + c1) / (mean * mean + 120 * 120 + c1), 1e-9);
    // Half the contrast: the luminance is the same.
    EXPECT_NEAR(ssim(a, chequered(115, 85)), (2 * deviation * 15 + c2) / (deviation * deviation + 15 * 15 + c2), 1e-9);
    // The negative: the covariance is minus the variance.
    EXPECT_NEAR(ssim(a, chequered(70, 130)), (c2 - 2 * deviation * deviation) / (c2 + 2 * deviation * deviation), 1e-9);
    EXPECT_EQ(ssim(a, Image{63, 48, {}, {}}), 0);
}

} // namespace
} // namespace penumbra::gui
