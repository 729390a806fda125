// "Copy as command": the line that stands for a state, run by a shell, draws the picture that the state itself draws.
#include "capture.h"
#include "files/read_state.h"
#include "files/render_command.h"

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
using nlohmann::json;

std::string text(const fs::path &file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

class RenderCommand : public testing::Test {
protected:
    void SetUp() override {
        folder = fs::temp_directory_path() / ("penumbra-commands-" + std::to_string(::getpid()));
        fs::create_directories(folder / "bin");
        fs::create_symlink(PENUMBRA_PROGRAM, folder / "bin/penumbra");
    }
    void TearDown() override { fs::remove_all(folder); }

    int shell(const std::string &line) const {
        const std::string all = "cd '" + folder.string() + "' && unset DISPLAY WAYLAND_DISPLAY && PATH='" +
                                (folder / "bin").string() + "':\"$PATH\" && " + line + " >.out 2>.err";
        const int status = std::system(all.c_str());
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }
    /// The picture of the state, and that of its line; labels are left out, for they tell the seconds.
    void expect_same(json state, const std::string &stem = "slanted-edge") {
        SCOPED_TRACE(state.dump());
        state["picture"].update({{"labels", false}});
        std::ofstream(folder / "s.penumbra.json") << state;
        ASSERT_EQ(shell("penumbra render s.penumbra.json -q -o state.png"), 0) << text(folder / ".err");
        // As the window does it, from what the picture has come to.
        const auto kept = read_png_state(folder / "state.png");
        ASSERT_TRUE(kept);
        const std::string line = render_command(read_state("state.png", *kept));
        SCOPED_TRACE(line);
        fs::remove(folder / (stem + ".png"));
        ASSERT_EQ(shell(line), 0) << text(folder / ".err");
        const Image by_state = read_png(folder / "state.png"), by_line = read_png(folder / (stem + ".png"));
        EXPECT_EQ(by_state.width, by_line.width);
        EXPECT_EQ(by_state.rgb, by_line.rgb);
        EXPECT_EQ(by_state.alpha, by_line.alpha);
        json a = json::parse(*kept), b = json::parse(*read_png_state(folder / (stem + ".png")));
        EXPECT_EQ(a, b);
    }

    fs::path folder;
};

const json small = {{"width", 320}, {"height", 240}};

TEST_F(RenderCommand, APaneAtItsFixedPoint) {
    expect_same({{"scene", "slanted-edge"}, {"converged", true}, {"options", {{"threshold", 0.05}}}, {"picture", small}});
}

TEST_F(RenderCommand, PanesBetweenTwoPhasesSeenFromElsewhere) {
    expect_same({{"scene", "slanted-edge"},
                 {"position", 4},
                 {"strategies", {"uniform-wavelet", "discontinuity-constant", "uniform-constant", "discontinuity-wavelet"}},
                 {"active", 2},
                 {"camera", {{"eye", {0.3, -6, 1.0 / 3}}, {"target", {0, 0, 0.1}}, {"up", {0.6, 0, 0.8}}, {"fov", 31.7}}},
                 {"options", {{"threshold", 0.1 / 3}, {"basis", "planar"}, {"order", 2}, {"max_depth", 3}, {"effects", {{"order", "off"}}}}},
                 {"exposure", -1.25},
                 {"range", {-0.01, 0.3}},
                 {"false_colour", true},
                 {"background", "light"},
                 {"layers", {{"mesh", false}, {"curves", false}, {"links", true}, {"fresh", false}, {"legend", false}}},
                 {"picture", small}});
}

TEST_F(RenderCommand, InTheMiddleOfARefinement) {
    const json room = {{"scene", "cornell-box"}, {"position", 4}, {"options", {{"threshold", 0.03}}}, {"picture", small}};
    for (const auto &[field, k] : {std::pair("split", 2), std::pair("linking", 40)}) {
        json state = room;
        state[field] = k;
        expect_same(state, "cornell-box");
        EXPECT_EQ(json::parse(*read_png_state(folder / "cornell-box.png"))[field], k);
    }
    EXPECT_EQ(shell("penumbra render cornell-box --steps 2 --split 2 -o a.png"), 2) << "of which refinement?";
    EXPECT_EQ(shell("penumbra render cornell-box --steps 2 --phase refined --split 2 --link 2 -o a.png"), 2);
}

TEST_F(RenderCommand, TwoStrategiesInOnePlace) {
    json state{{"scene", "slanted-edge"},
               {"converged", true},
               {"strategies", {"uniform-constant", "discontinuity-wavelet"}},
               {"active", 1},
               {"wipe", 1.0 / 3},
               {"options", {{"threshold", 0.05}}},
               {"picture", small}};
    for (const char *layout : {"wipe", "flip", "difference"}) {
        state["layout"] = layout;
        expect_same(state);
    }
    state["error"] = {{"kind", "signed"}, {"range", {-0.25, 0.25}}};
    expect_same(state);
}

TEST_F(RenderCommand, PanesWithViewsOfTheirOwn) {
    const json near{{"eye", {0.3, -3, 1.0 / 3}}, {"target", {0, 0, 0.1}}, {"fov", 31.7}};
    const json above{{"eye", {0.3, -1, 5}}, {"target", {0, 0, 0.1}}, {"fov", 25}};
    expect_same({{"scene", "slanted-edge"},
                 {"converged", true},
                 {"strategies", {"uniform-constant", "discontinuity-wavelet"}},
                 {"camera", near},
                 {"cameras", {near, above}},
                 {"options", {{"threshold", 0.05}}},
                 {"picture", small}});
}

TEST_F(RenderCommand, ToATolerance) {
    expect_same({{"scene", "slanted-edge"}, {"converged", true}, {"options", {{"tolerance", 0.05}, {"max_depth", 20}}}, {"picture", small}});
    expect_same({{"scene", "slanted-edge"}, {"converged", true}, {"options", {{"tolerance", 0.05}, {"max_depth", 8}}}, {"picture", small}});
}

TEST_F(RenderCommand, ErrorsAndAProfile) {
    expect_same({{"scene", "slanted-edge"},
                 {"position", 3},
                 {"strategies", {"discontinuity-constant", "discontinuity-constant"}},
                 {"reconstructed", {false, true}},
                 {"options", {{"threshold", 0.1}}},
                 {"shading", "error"},
                 {"error", {{"kind", "signed"}, {"range", {-0.03, 0.03}}}},
                 {"profile", {{-1, 0, 0}, {1, 0.25, 0}}},
                 {"picture", small}});
}

TEST_F(RenderCommand, AKeyholeAndFewCurves) {
    expect_same({{"scene", "skew-blockers"},
                 {"position", 0},
                 {"keyhole", {0.5, -0.45, 0}},
                 {"curves", {{"kinds", {"VE", "EEE"}}, {"orders", json::array()}, {"source", 1}, {"shown", 3}}},
                 {"picture", {{"width", 640}, {"height", 480}, {"lettered", true}}}},
                "skew-blockers");
}

TEST_F(RenderCommand, ASmoothClearPicture) {
    expect_same({{"scene", "slanted-edge"},
                 {"position", 3},
                 {"layers", {{"curves", false}}},
                 {"picture", {{"width", 200}, {"height", 150}, {"supersample", 2}, {"transparent", true}}}});
}

TEST_F(RenderCommand, ASceneInAFileWithAnAwkwardName) {
    const std::string name = "a room's $HOME; \"x\" *.obj";
    std::ofstream(folder / name) << "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
    expect_same({{"scene", "a room's $HOME; \"x\" *"}, {"file", name}, {"up", "y"}, {"position", 0}, {"picture", small}},
                "a room's $HOME; \"x\" *");
}

TEST_F(RenderCommand, WordsComeThroughTheShell) {
    for (const std::string word : {"plain-1.5:2,x=y", "", "a b", "it's", "$HOME `ls` \"*\" \\ ~ #!", "-o", "\t tab", "ü"}) {
        ASSERT_EQ(shell("printf %s " + shell_word(word)), 0) << word;
        EXPECT_EQ(text(folder / ".out"), word);
    }
}

/// What is as render has it by itself is left out.
TEST_F(RenderCommand, OnlyWhatDiffersIsSaid) {
    SavedState state;
    state.scene = "figure-4";
    state.converged = true;
    state.look.emphasise_fresh = false;
    state.picture = SavedPicture{};
    EXPECT_EQ(render_command(state), "penumbra render figure-4 --threshold 0.02 -o figure-4.png");
    state.look.exposure_ev = -0.5;
    state.look.range = Range{-1, 2};
    EXPECT_EQ(render_command(state),
              "penumbra render figure-4 --threshold 0.02 --exposure=-0.5 --range=-1:2 -o figure-4.png");
}

} // namespace
} // namespace penumbra
