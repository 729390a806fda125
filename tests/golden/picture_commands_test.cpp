// The commands `render` and `paper` as scripts see them, on a machine with no display.
#include "capture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <sys/wait.h>
#include <unistd.h>

namespace penumbra {
namespace {

namespace fs = std::filesystem;

std::string text(const fs::path &file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

class PictureCommands : public testing::Test {
protected:
    void SetUp() override {
        folder = fs::temp_directory_path() / ("penumbra-pictures-" + std::to_string(::getpid()));
        fs::create_directories(folder);
    }
    void TearDown() override { fs::remove_all(folder); }

    int run(const std::string &arguments) const {
        const std::string line = "cd '" + folder.string() + "' && unset DISPLAY WAYLAND_DISPLAY && exec '" PENUMBRA_PROGRAM "' " +
                                 arguments + " >.out 2>.err";
        const int status = std::system(line.c_str());
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }
    nlohmann::json state(const std::string &png) const {
        return nlohmann::json::parse(read_png_state(folder / png).value_or("null"));
    }

    fs::path folder;
};

TEST_F(PictureCommands, PaperDrawsTheFiguresAndTheTable) {
    ASSERT_EQ(run("paper -o out"), 0) << text(folder / ".err");
    for (const char *name : {"figure-5", "figure-6", "figure-7", "figure-8", "sheet"}) {
        const Image image = read_png(folder / "out" / (std::string(name) + ".png"));
        EXPECT_GE(image.width, 1000) << name;
    }
    EXPECT_EQ(state("out/figure-8.png")["strategies"], nlohmann::json::array({"discontinuity-wavelet"}));
    EXPECT_EQ(state("out/sheet.png")["strategies"].size(), 4u);

    std::istringstream csv(text(folder / "out/table.csv"));
    std::string line;
    std::getline(csv, line);
    EXPECT_THAT(line, testing::StartsWith("strategy,patches,paper_patches,coefficients,links,kernel_evaluations,seconds,error"));
    std::vector<int> patches, of_paper;
    std::vector<double> errors;
    while (std::getline(csv, line)) {
        std::vector<std::string> fields;
        std::istringstream row(line);
        for (std::string field; std::getline(row, field, ',');)
            fields.push_back(field);
        patches.push_back(std::stoi(fields.at(1)));
        of_paper.push_back(std::stoi(fields.at(2)));
        errors.push_back(std::stod(fields.at(7)));
    }
    EXPECT_THAT(of_paper, testing::ElementsAre(1776, 1019, 262, 3));
    ASSERT_EQ(patches.size(), 4u);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_GT(patches[i], patches[i + 1]);
        EXPECT_GT(2 * patches[i], of_paper[i]);
        EXPECT_LT(patches[i], 2 * of_paper[i]);
    }
    EXPECT_EQ(patches[3], 3);
    EXPECT_LE(errors[3], errors[0]) << "three patches are no less accurate than (a)";
}

TEST_F(PictureCommands, RenderObeysItsOptions) {
    ASSERT_EQ(run("render slanted-edge -o a.png --size 320x200 --steps 2 --layers links --shading flat --exposure 1.5 "
                  "--range 0:0.02 --view \"0 -6 4 0 0 1 35\" --threshold 0.05"),
              0)
        << text(folder / ".err");
    const Image image = read_png(folder / "a.png");
    EXPECT_EQ(image.width, 320);
    EXPECT_EQ(image.height, 200);
    const nlohmann::json j = state("a.png");
    EXPECT_EQ(j["scene"], "slanted-edge");
    EXPECT_EQ(j["iteration"], 2);
    EXPECT_EQ(j["shading"], "flat");
    EXPECT_EQ(j["exposure"], 1.5);
    EXPECT_EQ(j["range"], nlohmann::json::array({0.0, 0.02}));
    EXPECT_EQ(j["camera"]["eye"], nlohmann::json::array({0.0, -6.0, 4.0}));
    EXPECT_EQ(j["camera"]["fov"], 35.0);
    EXPECT_EQ(j["layers"]["mesh"], false);
    EXPECT_EQ(j["layers"]["links"], true);

    ASSERT_EQ(run("render slanted-edge -o b.png --size 320x200 --steps 2 --threshold 0.05"), 0);
    EXPECT_NE(read_png(folder / "b.png").rgb, image.rgb);
    ASSERT_EQ(run("render slanted-edge -o d.png --size 640x480 --layout compare --steps 1 --threshold 0.05"), 0);
    EXPECT_EQ(state("d.png")["strategies"].size(), 4u);
}

TEST_F(PictureCommands, RenderShowsOneCurveAndHidesOthers) {
    const std::string common = "render skew-blockers --size 320x240 --steps 0 ";
    ASSERT_EQ(run(common + "-o all.png"), 0) << text(folder / ".err");
    ASSERT_EQ(run(common + "-o one.png --curve 3"), 0);
    ASSERT_EQ(run(common + "-o few.png --curve-kinds EEE,contact --curve-orders 2 --curve-source light"), 0);
    const Image all = read_png(folder / "all.png");
    EXPECT_NE(read_png(folder / "one.png").rgb, all.rgb);
    EXPECT_NE(read_png(folder / "few.png").rgb, all.rgb);
    EXPECT_EQ(state("one.png")["curves"]["shown"], 3);
    EXPECT_EQ(state("all.png")["curves"]["shown"], nullptr);
    const nlohmann::json curves = state("few.png")["curves"];
    EXPECT_EQ(curves["kinds"], nlohmann::json::array({"EEE", "contact"}));
    EXPECT_EQ(curves["orders"], nlohmann::json::array({2}));
    EXPECT_EQ(curves["source"], 1);
    EXPECT_EQ(run(common + "-o a.png --curve 100000"), 3);
    EXPECT_THAT(text(folder / ".err"), testing::HasSubstr("curves, counted from 0"));
    EXPECT_EQ(run(common + "-o a.png --curve-source sun"), 3);
    EXPECT_FALSE(fs::exists(folder / "a.png"));
}

TEST_F(PictureCommands, PanesChosenStandSideBySide) {
    ASSERT_EQ(run("render soft-shadow --panes d,c --threshold 0.02 --size 640x480 -o two.png"), 0) << text(folder / ".err");
    EXPECT_EQ(state("two.png")["strategies"], nlohmann::json::array({"discontinuity-wavelet", "uniform-wavelet"}));
    EXPECT_EQ(state("two.png")["layout"], "two");
    for (const char *wrong : {"c,", ",c", "cd", "c,e", "c d", "\"\"", "cq", "b,q", "bqq", "qb"})
        EXPECT_EQ(run(std::string("render soft-shadow -o a.png --panes ") + wrong), 2) << wrong;
}

TEST_F(PictureCommands, ConstantsStandBesideTheirQuadratics) {
    ASSERT_EQ(run("render slanted-edge --panes b,bq --threshold 0.1 --size 640x480 -o a.png"), 0) << text(folder / ".err");
    const nlohmann::json j = state("a.png");
    EXPECT_EQ(j["strategies"], nlohmann::json::array({"discontinuity-constant", "discontinuity-constant"}));
    EXPECT_EQ(j["reconstructed"], nlohmann::json::array({false, true}));
    // The picture opens again as it was, but for the seconds in its labels.
    ASSERT_EQ(run("render a.png -o b.png"), 0) << text(folder / ".err");
    EXPECT_EQ(state("b.png")["reconstructed"], j["reconstructed"]);
    const Image a = read_png(folder / "a.png"), b = read_png(folder / "b.png");
    ASSERT_EQ(a.rgb.size(), b.rgb.size());
    std::size_t n = 0;
    for (std::size_t i = 0; i < a.rgb.size(); ++i)
        n += a.rgb[i] != b.rgb[i];
    EXPECT_LT(static_cast<double>(n) / static_cast<double>(a.rgb.size()), 0.005);
    // In the profile along a line each has its own points.
    ASSERT_EQ(run("render slanted-edge --panes b,bq --threshold 0.1 -o p.png --profile '-1 0 0 1 0 0'"), 0)
        << text(folder / ".err");
    const std::string csv = text(folder / "p-profile.csv");
    EXPECT_NE(csv.find("\ndiscontinuity-constant,"), csv.npos);
    EXPECT_NE(csv.find("\ndiscontinuity-constant as quadratics,"), csv.npos);
}

/// The price of cutting where it does not pay, as the picture in the README tells it.
TEST_F(PictureCommands, SoftShadowsAreNotWorthCutting) {
    const auto solve = [&](const std::string &strategy) {
        EXPECT_EQ(run("solve soft-shadow --threshold 0.002 -o " + strategy + ".json --strategy " + strategy), 0);
        return nlohmann::json::parse(text(folder / (strategy + ".json")))["final"];
    };
    const nlohmann::json uniform = solve("uniform-wavelet"), cut = solve("discontinuity-wavelet");
    EXPECT_LE(uniform["error"].get<double>(), cut["error"].get<double>());
    EXPECT_LE(uniform["coefficients"].get<int>(), cut["coefficients"].get<int>());
    EXPECT_LT(2 * uniform["clips"].get<int>(), cut["clips"].get<int>());
}

TEST_F(PictureCommands, RenderLooksThroughTheKeyhole) {
    const std::string common = "render skew-blockers --size 640x480 --steps 0 ";
    ASSERT_EQ(run(common + "-o plain.png"), 0) << text(folder / ".err");
    ASSERT_EQ(run(common + "-o keyhole.png --keyhole \"0.5 -0.45 0\""), 0) << text(folder / ".err");
    // Light on night, in a column at the right.
    const auto bright = [](const Image &image) {
        std::size_t n = 0;
        for (std::size_t y = 0; y < 480; ++y)
            for (std::size_t x = 400; x < 640; ++x) {
                const std::uint8_t *rgb = &image.rgb[3 * (640 * y + x)];
                n += rgb[0] == 255 && rgb[1] == 243 && rgb[2] == 208 ? 1 : 0;
            }
        return n;
    };
    EXPECT_EQ(bright(read_png(folder / "plain.png")), 0u);
    EXPECT_GT(bright(read_png(folder / "keyhole.png")), 1500u);
    const nlohmann::json point = state("keyhole.png")["keyhole"];
    EXPECT_NEAR(point[0].get<double>(), 0.5, 1e-12);
    EXPECT_NEAR(point[1].get<double>(), -0.45, 1e-12);
    EXPECT_EQ(state("plain.png")["keyhole"], nullptr);
    EXPECT_EQ(run(common + "-o a.png --keyhole \"0 0 1\""), 3);
    EXPECT_THAT(text(folder / ".err"), testing::HasSubstr("no surface that reflects"));
    EXPECT_EQ(run(common + "-o a.png --keyhole \"0 0\""), 2);
    EXPECT_FALSE(fs::exists(folder / "a.png"));
}

TEST_F(PictureCommands, ErrorPicturesTellTheirKindAndRange) {
    const std::string common = "render slanted-edge --threshold 0.05 --size 400x300 --shading error ";
    ASSERT_EQ(run(common + "-o signed.png"), 0) << text(folder / ".err");
    ASSERT_EQ(run(common + "-o patch.png --error patch --error-range 1e-4:0.1 --panes a,d"), 0)
        << text(folder / ".err");
    EXPECT_EQ(state("signed.png")["shading"], "error");
    EXPECT_EQ(state("signed.png")["error"]["kind"], "signed");
    EXPECT_EQ(state("patch.png")["error"],
              nlohmann::json::parse(R"({"kind": "patch", "range": [1e-4, 0.1], "locked": true, "change": null})"));
    // The picture's state draws it again.
    ASSERT_EQ(run("render patch.png -o again.png"), 0) << text(folder / ".err");
    EXPECT_EQ(state("again.png")["error"], state("patch.png")["error"]);
    // Too bright is brown, too dark is blue: both must be there.
    const Image image = read_png(folder / "signed.png");
    int brown = 0, blue = 0;
    for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
        brown += image.rgb[i] > image.rgb[i + 2] + 60;
        blue += image.rgb[i + 2] > image.rgb[i] + 60;
    }
    EXPECT_GT(brown, 200);
    EXPECT_GT(blue, 200);
}

TEST_F(PictureCommands, AProfileIsPlottedBesideThePicture) {
    const std::string common = "render figure-4 --threshold 0.05 --size 400x300 --panes a,d ";
    const nlohmann::json record = [&] {
        EXPECT_EQ(run(common + "-o plain.png"), 0);
        return state("plain.png");
    }();
    EXPECT_EQ(record["profile"], nullptr);
    ASSERT_EQ(run(common + "-o lined.png --profile \"0.1 0.2 0 0.9 0.7 0\""), 0) << text(folder / ".err");
    EXPECT_GT(read_png(folder / "lined-profile.png").width, 1000);
    EXPECT_THAT(text(folder / "lined-profile.svg"), testing::HasSubstr("discontinuity curves"));
    const nlohmann::json ends = state("lined.png")["profile"];
    EXPECT_NEAR(ends[1][0].get<double>(), 0.9, 1e-12);
    EXPECT_NEAR(ends[1][1].get<double>(), 0.7, 1e-12);
    std::istringstream csv(text(folder / "lined-profile.csv"));
    std::string line;
    std::getline(csv, line);
    EXPECT_EQ(line, "curve,at,x,y,z,r,g,b,slope_r,slope_g,slope_b,element");
    std::map<std::string, int> rows;
    while (std::getline(csv, line))
        ++rows[line.substr(0, line.find(','))];
    EXPECT_THAT(rows, testing::SizeIs(3));
    EXPECT_GE(rows["truth"], 501);
    EXPECT_GE(rows["discontinuity-wavelet"], 500);
    EXPECT_EQ(run(common + "-o a.png --profile \"0.1 0.2 0.5 0.9 0.7 0.5\""), 3);
    EXPECT_THAT(text(folder / ".err"), testing::HasSubstr("holds both points"));
    EXPECT_FALSE(fs::exists(folder / "a.png"));
}

TEST_F(PictureCommands, AWipeIsOneStrategyOnEachSideOfItsDivider) {
    const std::string common = "render slanted-edge --size 400x300 --threshold 0.05 --range 0:0.5 --no-labels --no-legend ";
    ASSERT_EQ(run(common + "--panes a -o a.png"), 0) << text(folder / ".err");
    ASSERT_EQ(run(common + "--panes d -o d.png"), 0) << text(folder / ".err");
    ASSERT_EQ(run(common + "--no-price --wipe 0.3 --panes a,d -o wipe.png"), 0) << text(folder / ".err");
    const Image a = read_png(folder / "a.png"), d = read_png(folder / "d.png"), wipe = read_png(folder / "wipe.png");
    ASSERT_EQ(wipe.rgb.size(), a.rgb.size());
    std::size_t as_a = 0, as_d = 0; // where the two differ
    for (int y = 0; y < wipe.height; ++y)
        for (int x = 0; x < wipe.width; ++x)
            for (int c = 0; c < 3; ++c) {
                const std::size_t i = 3 * (static_cast<std::size_t>(y) * 400 + static_cast<std::size_t>(x)) + static_cast<std::size_t>(c);
                if (std::abs(x - 120) < 4)
                    continue; // the divider
                ASSERT_EQ(wipe.rgb[i], (x < 120 ? a : d).rgb[i]) << x << " " << y;
                if (a.rgb[i] != d.rgb[i])
                    ++(x < 120 ? as_a : as_d);
            }
    EXPECT_GT(as_a, 1000U);
    EXPECT_GT(as_d, 1000U);
    EXPECT_EQ(state("wipe.png")["layout"], "wipe");
    EXPECT_EQ(state("wipe.png")["wipe"], 0.3);
}

TEST_F(PictureCommands, WrongUseBadInputAndNoPlaceHaveTheirStatuses) {
    for (const char *wrong :
         {"render figure-4", "render -o a.png", "render figure-4 -o a.png --size 0x10",
          "render figure-4 -o a.png --size 10", "render figure-4 -o a.png --layers mess",
          "render figure-4 -o a.png --shading wrong", "render figure-4 -o a.png --error huge",
          "render figure-4 -o a.png --error-range 1:2", "render figure-4 -o a.png --error patch --error-range 0:2",
          "render figure-4 -o a.png --profile \"0 0 0 1 1\"", "render figure-4 -o a.png --range 2:1",
          "render figure-4 -o a.png --view \"1 2 3\"", "render figure-4 -o a.png --layout triple",
          "render figure-4 -o a.png --layout wipe --panes a,b,c", "render figure-4 -o a.png --layout difference --panes d",
          "render figure-4 -o a.png --wipe 1.5", "render figure-4 -o a.png --pane-steps \"0 refine\"",
          "render figure-4 -o a.png --pane-steps \"1 reed\"", "render figure-4 -o a.png --pane-steps 1 --steps 1",
          "render figure-4 -o a.png --pane-range 2:1", "render figure-4 -o a.png --pane-exposure 41",
          "render figure-4 -o a.png --pane-camera \"1 2 3\"",
          "render figure-4 -o a.png --curve -1", "render figure-4 -o a.png --curve-kinds VE,XY",
          "render figure-4 -o a.png --curve-orders 3", "render figure-4 -o a.png --steps -1", "paper"}) {
        EXPECT_EQ(run(wrong), 2) << wrong;
        EXPECT_FALSE(fs::exists(folder / "a.png")) << wrong;
    }
    EXPECT_EQ(run("render nowhere.obj -o a.png"), 3);
    EXPECT_EQ(run("render figure-4 -o a.png --panes a,d --pane-camera \"3 -4 3 0 0 0 0 0 1 30\""), 3);
    EXPECT_THAT(text(folder / ".err"), testing::HasSubstr("there are 1 for 2 panes; give one for each"));
    for (const char *given : {"--pane-exposure 1", "--pane-steps 3", "--pane-range own"})
        EXPECT_EQ(run("render figure-4 -o a.png --panes a,d " + std::string(given)), 3) << given;
    EXPECT_EQ(run("render figure-4 -o a.png --panes a,d --layout wipe --pane-range own --pane-range own"), 3);
    EXPECT_THAT(text(folder / ".err"), testing::HasSubstr("there are 2 for panes in one place; give one for each"));
    EXPECT_EQ(run("render figure-4 -o no/such/folder/a.png"), 5);
    std::ofstream(folder / "file") << "in the way";
    EXPECT_EQ(run("paper -o file/out"), 5);
}

} // namespace
} // namespace penumbra
