// Pictures with settings, of both meshings, of all steps; and the command that makes the same one.
#include "gui/session.h"

#include "capture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sys/wait.h>

namespace penumbra::gui {
namespace {

namespace fs = std::filesystem;

Json state_of(const fs::path &png) { return Json::parse(read_png_state(png).value_or("null")); }

/// Presses it and waits for the picture that comes of it.
fs::path picture(Session &session, const std::string &key) {
    const Json before = session.settled();
    session.key(key);
    const Json after = session.wait_until(key, [&](const Json &s) {
        return s["picture"] != before["picture"] && s["pictures"]["pending"] == 0;
    });
    return after["picture"].get<std::string>();
}

/// Runs the copied line by a shell, in a new folder without a display; the picture that it draws.
Image run_copied(Session &session, const std::string &stem) {
    const Json before = session.settled();
    session.key("ctrl+shift+c");
    const Json after = session.wait_until("the line", [&](const Json &s) {
        return s["message"].get<std::string>().starts_with("Copied: ") &&
               s["pictures"]["command"] != before["pictures"]["command"];
    });
    const auto line = after["pictures"]["command"].get<std::string>();
    SCOPED_TRACE(line);
    EXPECT_EQ(after["message"], "Copied: " + line);
    const fs::path folder = session.home() / "copied";
    fs::create_directories(folder / "bin");
    if (!fs::exists(folder / "bin/penumbra"))
        fs::create_symlink(PENUMBRA_PROGRAM, folder / "bin/penumbra");
    const std::string all = "cd '" + folder.string() + "' && unset DISPLAY WAYLAND_DISPLAY && PATH='" +
                            (folder / "bin").string() + "':\"$PATH\" && " + line + " -q";
    const int status = std::system(all.c_str());
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << line;
    return read_png(folder / (stem + ".png"));
}

double share_that_differs(const Image &a, const Image &b) {
    if (a.width != b.width || a.height != b.height || a.alpha.size() != b.alpha.size())
        return 1;
    std::size_t n = 0;
    for (std::size_t i = 0; i < a.rgb.size(); ++i)
        n += a.rgb[i] != b.rgb[i];
    return static_cast<double>(n) / static_cast<double>(a.rgb.size());
}

/// But for the seconds in the labels.
void expect_same_picture(Session &session, const std::string &stem = "figure-4") {
    const Image copied = run_copied(session, stem);
    const Image saved = read_png(picture(session, "F12"));
    EXPECT_LT(share_that_differs(saved, copied), 0.003);
}

TEST(Pictures, StepsAndExposuresOfTheirOwnAreInTheCopiedLine) {
    Session session;
    for (const char *key : {"ctrl+2", "shift+s", "Right", "shift+Tab", "shift+Right", "shift+k", "e", "shift+Tab", "c"}) {
        session.key(key);
        session.settled();
    }
    expect_same_picture(session);
    const auto line = session.state()["pictures"]["command"].get<std::string>();
    for (const char *part : {"--pane-steps '1 refine' --pane-steps 1", "--pane-exposure 0.5 --pane-exposure 0 ", "--pane-range own --pane-range own"})
        EXPECT_NE(line.find(part), std::string::npos) << part << " in " << line;
}

TEST(Pictures, TheCopiedLineMakesTheSamePicture) {
    Session session;
    session.key("Right");
    session.wait_until("a step", [](const Json &s) { return s["position"] == 3 && !s["busy"]; });
    expect_same_picture(session);
    for (const char *key : {"ctrl+2", "shift+Right", "v", "e", "l", "b"}) {
        session.key(key);
        session.settled();
    }
    const Box pane = session.widget("pane 0");
    session.drag({pane.x + 0.5 * pane.width, pane.y + 0.5 * pane.height},
                 {pane.x + 0.6 * pane.width, pane.y + 0.55 * pane.height});
    expect_same_picture(session);
    for (const char *key : {"v", "l", "k", "ctrl+4"}) {
        session.key(key);
        session.settled();
    }
    expect_same_picture(session);
    for (const char *key : {"k", "ctrl+1", "1", "q", "End"}) {
        session.key(key);
        session.settled();
    }
    session.wait_until("the end", [](const Json &s) { return s["panes"][0].value("converged", false) && !s["busy"]; });
    expect_same_picture(session);
    for (const char *key : {"x", "shift+x", "s"}) {
        session.key(key);
        session.settled();
    }
    expect_same_picture(session);
}

TEST(Pictures, TheCopiedLineMakesTheSamePictureOfTwoStrategiesInOnePlace) {
    Session session({"slanted-edge", "--threshold", "0.05"});
    session.key("Right");
    session.wait_until("a step", [](const Json &s) { return s["position"] == 3 && !s["busy"]; });
    const auto solved = [&] {
        session.wait_until("both", [](const Json &s) {
            return !s["busy"] && std::ranges::all_of(s["panes"], [](const Json &p) { return p.value("computed", 0) >= 3; });
        });
        session.settled();
    };
    session.key("w");
    session.wait_until("the wipe", [](const Json &s) { return s["layout"] == "wipe"; });
    solved();
    const Point divider = session.middle("divider");
    session.move({divider.x, divider.y + 50});
    session.wait_until("the mouse is there", [](const Json &s) { return s["told"]["control"] == "divider"; });
    session.hold(Point{divider.x, divider.y + 50});
    session.wait_until("it is held", [](const Json &s) { return s["told"]["control"] == ""; });
    session.move({divider.x - 111, divider.y + 50});
    session.wait_until("the divider follows", [](const Json &s) { return s["wipe"].get<double>() < 0.45; });
    session.let_go();
    expect_same_picture(session, "slanted-edge");
    for (const char *key : {"shift+w", "shift+w", "shift+d"}) {
        session.key(key);
        solved();
        if (session.state()["layout"] == "difference")
            session.wait_until("the difference", [](const Json &s) { return !s["panes"][1]["error"].is_null() && !s["busy"]; });
        expect_same_picture(session, "slanted-edge");
    }
    EXPECT_EQ(session.state()["layout"], "difference");
    session.key("ctrl+2");
    session.key("shift+l");
    solved();
    const Box pane = session.widget("pane 0");
    session.hold(Point{pane.x + 0.5 * pane.width, pane.y + 0.5 * pane.height});
    session.wait_until("it is held", [](const Json &s) { return s["active"] == 0 && s["cameras"].size() == 2; });
    session.move({pane.x + 0.6 * pane.width, pane.y + 0.55 * pane.height});
    session.wait_until("one view turns", [](const Json &s) { return s["cameras"][0] != s["cameras"][1]; });
    session.let_go();
    expect_same_picture(session, "slanted-edge");
}

/// What is in the clipboard is seen by pasting it where a file's name is typed: there is no such file, which is said.
/// As another program gets it when one pastes there.
TEST(Pictures, TheLineIsInTheClipboard) {
    Session session;
    session.key("ctrl+shift+c");
    const Json after = session.wait_until("the line", [](const Json &s) { return s["pictures"]["command"] != ""; });
    EXPECT_EQ(session.clipboard(), after["pictures"]["command"].get<std::string>());
}

TEST(Pictures, BothMeshingsInOneKeystrokeWhateverIsShown) {
    Session session({"figure-4", "--threshold", "0.03"});
    session.key("1");
    session.key("Right");
    session.wait_until("a step", [](const Json &s) { return s["position"] == 3 && !s["busy"]; });
    session.key("e");
    const Json before = session.settled();
    ASSERT_EQ(before["layout"], "single");
    const fs::path file = picture(session, "shift+F12"); // (b) is not solved yet
    const Json saved = state_of(file), after = session.settled();
    EXPECT_EQ(saved["strategies"], Json::array({"uniform-constant", "discontinuity-constant"}));
    EXPECT_EQ(saved["position"], 3);
    EXPECT_EQ(saved["exposure"], before["exposure"]);
    EXPECT_EQ(saved["range"], before["range"]);
    EXPECT_EQ(saved["camera"]["eye"], before["camera"]["eye"]);
    EXPECT_EQ(saved["camera"]["target"], before["camera"]["target"]);
    for (const char *key : {"layout", "strategies", "position", "camera"})
        EXPECT_EQ(after[key], before[key]) << key;
    // The two are no mirror of one another: (a) has many patches.
    const Image image = read_png(file);
    std::size_t dark[2] = {0, 0};
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const std::uint8_t *rgb = &image.rgb[static_cast<std::size_t>(3 * (y * image.width + x))];
            dark[2 * x / image.width] += rgb[0] + rgb[1] + rgb[2] < 120;
        }
    EXPECT_NE(dark[0], dark[1]);
}

TEST(Pictures, EscGivesUpAPictureThatIsBeingSolvedFor) {
    // The first step takes (d) twenty times the work that it takes (c).
    Session session({"office", "--strategy", "uniform-wavelet", "--threshold", "0.02"});
    session.settled();
    session.key("Right");
    session.wait_until("a step", [](const Json &s) { return s["position"] == 3 && !s["busy"]; }, 120);
    const Json before = session.settled();
    session.key("shift+F12");
    const Json during = session.wait_until("progress", [](const Json &s) { return s["pictures"]["pending"] == 1; });
    EXPECT_NE(during["progress"].get<std::string>().find("(d) is being solved up to step 1"), std::string::npos)
        << during["progress"];
    session.key("Escape");
    session.wait_until("nothing pending", [](const Json &s) { return s["pictures"]["pending"] == 0; });
    const Json after = session.settled();
    EXPECT_EQ(after["picture"], before["picture"]);
    EXPECT_EQ(after["position"], before["position"]);
}

TEST(Pictures, AllStepsAreNumbered) {
    Session session({"slanted-edge", "--threshold", "0.05"});
    for (int step = 1; step <= 2; ++step) {
        session.key("Right");
        session.wait_until("a step", [&](const Json &s) { return s["panes"][0].value("iteration", 0) == step; });
        session.settled();
    }
    session.key("shift+Left"); // between two phases
    const Json before = session.settled();
    ASSERT_EQ(before["position"], 5);
    const fs::path last = picture(session, "ctrl+shift+F12");
    EXPECT_EQ(last, session.home() / "Pictures/penumbra-steps-1/step-2.png");
    for (int step = 0; step <= 2; ++step) {
        const Json s = state_of(last.parent_path() / ("step-" + std::to_string(step) + ".png"));
        EXPECT_EQ(s["position"], std::min(3 * step, 5));
        EXPECT_EQ(s["camera"], before["camera"]);
        EXPECT_EQ(s["range"], before["range"]);
    }
    EXPECT_EQ(std::distance(fs::directory_iterator(last.parent_path()), {}), 3);
    EXPECT_EQ(picture(session, "ctrl+shift+F12").parent_path().filename(), "penumbra-steps-2");
}

TEST(Pictures, TheSettingsAreObeyed) {
    Session session;
    session.click("menu.File");
    session.wait_until("the menu", [](const Json &s) { return s["widgets"].contains("menu.file.picture_settings"); });
    session.settled();
    session.click("menu.file.picture_settings");
    session.wait_until("the settings", [](const Json &s) { return s["pictures"]["settings_open"] == true; });
    session.settled();
    const auto choose = [&](const char *widget, const char *what, const Json &value) {
        EXPECT_NE(session.state()["pictures"][what], value) << widget << ": holds already";
        session.click(widget);
        session.wait_until(widget, [&](const Json &s) { return s["pictures"][what] == value; });
        session.settled();
    };
    choose("picture.1920", "size", Json::array({1920, 1080}));
    choose("picture.supersample 2", "supersample", 2);
    choose("picture.transparent", "transparent", true);
    choose("picture.labels", "labels", false);
    session.key("Escape");
    session.wait_until("closed", [](const Json &s) { return s["pictures"]["settings_open"] == false; });
    const fs::path file = picture(session, "F12");
    const Image image = read_png(file);
    EXPECT_EQ(image.width, 1920);
    EXPECT_EQ(image.height, 1080);
    ASSERT_FALSE(image.alpha.empty());
    EXPECT_EQ(std::ranges::min(image.alpha), 0);
    const Json saved = state_of(file)["picture"];
    EXPECT_EQ(saved["supersample"], 2);
    EXPECT_EQ(saved["transparent"], true);
    EXPECT_EQ(saved["labels"], false);
    // No label tells seconds: the line draws the same to the last bit.
    const Image copied = run_copied(session, "figure-4");
    EXPECT_EQ(copied.rgb, image.rgb);
    EXPECT_EQ(copied.alpha, image.alpha);
}

TEST(Pictures, ALargeOneIsDrawnBesidesAndEscGivesItUp) {
    const fs::path script = fs::path(testing::TempDir()) / ("large-picture-" + std::to_string(::getpid()) + ".txt");
    std::ofstream(script) << "pictures 3840x2160 4\n";
    Session session({"--script", script.string()});
    session.wait_until("the settings", [](const Json &s) { return s["pictures"]["supersample"] == 4 && s["script"]["playing"] == false; });
    fs::remove(script);
    session.settled();
    session.key("F12");
    const Json begun = session.wait_until("a part of it", [](const Json &s) { return s["pictures"]["drawn"].is_number(); });
    EXPECT_LT(begun["pictures"]["drawn"], 0.9);
    session.key("m"); // the window goes on
    session.wait_until("no mesh", [](const Json &s) { return s["layers"]["mesh"] == false && s["pictures"]["drawn"].is_number(); });
    session.key("Escape");
    const Json given_up = session.wait_until("it is given up", [](const Json &s) { return s["pictures"]["drawn"].is_null(); });
    EXPECT_EQ(given_up["message"], "No picture was taken.");
    EXPECT_EQ(given_up["picture"], "");
    EXPECT_TRUE(!fs::exists(session.home() / "Pictures") || fs::is_empty(session.home() / "Pictures"));
    // The next one is drawn to its end, as it was when it was asked for.
    session.key("F12");
    session.wait_until("a part of it", [](const Json &s) { return s["pictures"]["drawn"].is_number(); });
    session.key("m");
    const Json taken = session.wait_until("the picture", [](const Json &s) { return s["picture"] != ""; }, 120);
    EXPECT_EQ(taken["layers"]["mesh"], true);
    const fs::path file = taken["picture"].get<std::string>();
    EXPECT_EQ(state_of(file)["layers"]["mesh"], false);
    EXPECT_EQ(read_png(file).width, 3840);
}

} // namespace
} // namespace penumbra::gui
