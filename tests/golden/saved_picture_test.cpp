// Pictures and states as files that people keep: rendering one gives the same picture again.
#include "capture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <sys/wait.h>
#include <unistd.h>

namespace penumbra {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

std::string text(const fs::path &file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

class SavedPicture : public testing::Test {
protected:
    void SetUp() override {
        folder = fs::temp_directory_path() / ("penumbra-saved-" + std::to_string(::getpid()));
        fs::create_directories(folder / "more");
        std::ofstream(folder / "room.obj")
            << "mtllib room.mtl\nusemtl floor\nv 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\nf 4 3 2 1\n"
               "usemtl lamp\nv 0.2 1 0.2\nv 0.4 1 0.2\nv 0.4 1 0.4\nf 5 6 7\n";
        std::ofstream(folder / "room.mtl") << "newmtl floor\nKd 0.5 0.6 0.7\nnewmtl lamp\nKd 0 0 0\nKe 9 9 9\n";
    }
    void TearDown() override { fs::remove_all(folder); }

    int run(const std::string &arguments) const {
        const std::string line = "cd '" + folder.string() +
                                 "' && unset DISPLAY WAYLAND_DISPLAY && exec '" PENUMBRA_PROGRAM "' " + arguments +
                                 " >.out 2>.err";
        const int status = std::system(line.c_str());
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }
    std::string err() const { return text(folder / ".err"); }
    nlohmann::json state(const std::string &png) const {
        return nlohmann::json::parse(read_png_state(folder / png).value_or("null"));
    }
    Image image(const std::string &png) const { return read_png(folder / png); }

    fs::path folder;
};

/// Rows that differ. The second line of a pane's label tells the seconds of its own run; all else is deterministic.
std::vector<int> rows_that_differ(const Image &a, const Image &b) {
    EXPECT_EQ(a.width, b.width);
    EXPECT_EQ(a.height, b.height);
    const auto row = static_cast<std::ptrdiff_t>(3 * a.width);
    std::vector<int> rows;
    for (std::ptrdiff_t y = 0; y < std::min(a.height, b.height); ++y)
        if (!std::equal(a.rgb.begin() + y * row, a.rgb.begin() + (y + 1) * row, b.rgb.begin() + y * row))
            rows.push_back(static_cast<int>(y));
    return rows;
}

/// Nothing is timed before the first step: every bit is the same.
TEST_F(SavedPicture, APictureRendersToTheSameBits) {
    ASSERT_EQ(
        run("render room.obj --up y --steps 0 -o a.png --size 400x300 --layers mesh,links --shading flat --exposure "
            "0.5 "
            "--range 0:0.3 --view \"2 2 1 0.5 0 0.5 40\" --basis planar --order 2 --background light --false-colour"),
        0)
        << err();
    ASSERT_EQ(run("render a.png -o more/b.png"), 0) << err();
    EXPECT_EQ(image("a.png").rgb, image("more/b.png").rgb);
    nlohmann::json a = state("a.png"), b = state("more/b.png");
    EXPECT_EQ(a["file"], "room.obj");
    EXPECT_EQ(b["file"], "../room.obj");
    a["file"] = b["file"] = "";
    EXPECT_EQ(a, b);

    const std::string panes =
        "render skew-blockers --layout compare --steps 0 --size 640x480 --keyhole \"0.5 -0.45 0\" --curve 3 ";
    ASSERT_EQ(run(panes + "-o four.png --curve-kinds VE,EEE"), 0) << err();
    ASSERT_EQ(run("render four.png -o again.png"), 0) << err();
    EXPECT_EQ(text(folder / "four.png"), text(folder / "again.png")) << "the file itself";
    ASSERT_EQ(run(panes + "-o other.png"), 0);
    EXPECT_NE(image("other.png").rgb, image("four.png").rgb) << "the control";
}

TEST_F(SavedPicture, AfterStepsAllButTheSecondsIsTheSame) {
    for (const char *way : {"", "--steps 1 ", "--threshold 0.05 --strategy uniform-constant "}) {
        ASSERT_EQ(run(std::string("render slanted-edge ") + way + "-o a.png --size 640x480"), 0) << err();
        ASSERT_EQ(run("render a.png -o b.png"), 0) << err();
        const std::vector<int> rows = rows_that_differ(image("a.png"), image("b.png"));
        if (!rows.empty()) {
            EXPECT_GE(rows.front(), 11) << way; // below the title
            EXPECT_LE(rows.back(), 40) << way;  // above the drawing
        }
        EXPECT_EQ(state("a.png"), state("b.png")) << way;
    }
    EXPECT_EQ(state("b.png")["converged"], true);
    ASSERT_EQ(run("render a.png -o c.png --exposure 1"), 0) << err();
    EXPECT_GT(rows_that_differ(image("a.png"), image("c.png")).size(), 100u) << "the control";
}

TEST_F(SavedPicture, AStateStopsAfterAPhase) {
    const auto phase = [&](int position) {
        std::ofstream(folder / "s.penumbra.json")
            << R"({"scene": "slanted-edge", "position": )" << position
            << R"(, "options": {"threshold": 0.05}, "picture": {"width": 320, "height": 240}})";
        EXPECT_EQ(run("render s.penumbra.json -o s.png"), 0) << err();
        return state("s.png");
    };
    EXPECT_EQ(phase(0)["phase"], "start");
    EXPECT_EQ(phase(1)["phase"], "refine");
    EXPECT_EQ(phase(5)["phase"], "gather");
    EXPECT_EQ(phase(5)["iteration"], 2);
    EXPECT_EQ(phase(6)["phase"], "push-pull");
    EXPECT_EQ(phase(3)["picture"]["width"], 320);
}

TEST_F(SavedPicture, AStateStopsInTheMiddleOfARefinement) {
    const auto render = [&](const std::string &split, const std::string &png) {
        std::ofstream(folder / "s.penumbra.json")
            << R"({"scene": "slanted-edge", "position": 7, "split": )" << split
            << R"(, "options": {"threshold": 0.05}, "picture": {"width": 640, "height": 480}})";
        EXPECT_EQ(run("render s.penumbra.json -o " + png), 0) << err();
        return state(png);
    };
    EXPECT_EQ(render("1", "one.png")["split"], 1);
    EXPECT_EQ(render("2", "two.png")["split"], 2);
    EXPECT_EQ(render("null", "all.png")["split"], nullptr);
    EXPECT_GT(rows_that_differ(image("one.png"), image("two.png")).size(), 10u);
    EXPECT_GT(rows_that_differ(image("two.png"), image("all.png")).size(), 10u);
    ASSERT_EQ(run("render two.png -o again.png"), 0) << err();
    EXPECT_EQ(state("again.png"), state("two.png"));
    for (const int row : rows_that_differ(image("two.png"), image("again.png")))
        EXPECT_LE(row, 40) << "the seconds alone are measured anew";
}

TEST_F(SavedPicture, WhatIsSaidBesideAStateHolds) {
    ASSERT_EQ(run("render slanted-edge --panes a,d --threshold 0.05 --steps 1 --exposure 2 -o a.png --size 320x240"), 0)
        << err();
    ASSERT_EQ(run("render a.png -o b.png --exposure 0 --size 400x300 --threshold 0.1 --layers none --steps 2 --view "
                  "\"0 -6 4 0 0 1 35\""),
              0)
        << err();
    const nlohmann::json b = state("b.png");
    EXPECT_EQ(b["exposure"], 0);
    EXPECT_EQ(b["picture"]["width"], 400);
    EXPECT_EQ(b["options"]["threshold"], 0.1);
    EXPECT_EQ(b["layers"]["mesh"], false);
    EXPECT_EQ(b["iteration"], 2);
    EXPECT_EQ(b["camera"]["fov"], 35);
    EXPECT_EQ(b["strategies"], state("a.png")["strategies"]);
    ASSERT_EQ(run("render a.png -o c.png --strategy uniform-wavelet"), 0);
    EXPECT_EQ(state("c.png")["strategies"], nlohmann::json::array({"uniform-wavelet"}));
    ASSERT_EQ(run("render a.png -o d.png --layout compare"), 0);
    EXPECT_EQ(state("d.png")["strategies"].size(), 4u);
}

TEST_F(SavedPicture, ThePapersFiguresComeBack) {
    ASSERT_EQ(run("paper -o out -q"), 0) << err();
    ASSERT_EQ(run("render out/figure-8.png -o again.png"), 0) << err();
    const Image figure = image("out/figure-8.png"), again = image("again.png");
    for (const int row : rows_that_differ(figure, again))
        EXPECT_LT(row, 80) << "below the label";
}

TEST_F(SavedPicture, WhatCannotBeOpenedIsThreeAndLeavesNothing) {
    ASSERT_EQ(run("render room.obj --steps 0 -o a.png --size 64x64"), 0) << err();
    fs::remove(folder / "room.obj");
    std::ofstream(folder / "torn.png") << text(folder / "a.png").substr(0, 100);
    std::ofstream(folder / "bad.penumbra.json") << R"({"scene": "figure-4", "exposure": 99})";
    write_png(folder / "plain.png", {1, 1, {1, 2, 3}});
    const std::pair<const char *, const char *> faults[] = {{"a.png", "its scene is not there (room.obj)"},
                                                            {"torn.png", "ends in the middle of a chunk"},
                                                            {"plain.png", "holds no state"},
                                                            {"bad.penumbra.json", "exposure is 99"}};
    for (const auto &[file, said] : faults)
        for (const std::string command : {"render ", "view "}) {
            EXPECT_EQ(run(command + file + (command == "render " ? " -o b.png" : "")), 3) << command << file;
            EXPECT_THAT(err(), HasSubstr(said)) << command << file;
            EXPECT_EQ(std::ranges::count(err(), '\n'), 1) << err();
            EXPECT_FALSE(fs::exists(folder / "b.png"));
        }
}

TEST_F(SavedPicture, CurvesAndPointsThatThereAreNotAreNamedByTheirField) {
    const std::pair<const char *, const char *> faults[] = {
        {R"("curves": {"shown": 100000})", "s.penumbra.json: curves.shown 100000: the scene has "},
        {R"("keyhole": [0, 0, 50])", "s.penumbra.json: keyhole: no surface that reflects lies within"},
        {R"("curves": {"source": 99})", "s.penumbra.json: curves.source is 99; the scene has "}};
    for (const auto &[field, said] : faults) {
        std::ofstream(folder / "s.penumbra.json") << R"({"scene": "figure-4", "position": 0, )" << field << "}";
        EXPECT_EQ(run("render s.penumbra.json -o b.png"), 3) << field;
        EXPECT_THAT(err(), HasSubstr(said));
        EXPECT_FALSE(fs::exists(folder / "b.png"));
        // What is said beside the state holds; a source that there is not has none.
        const int status = run("render s.penumbra.json -o b.png --curve 0 --keyhole \"0.5 0 0\"");
        EXPECT_EQ(status, std::string(field).ends_with("99}") ? 3 : 0) << err();
        fs::remove(folder / "b.png");
    }
}

} // namespace
} // namespace penumbra
