// Scenes that are dropped or named, and pictures that are taken.
#include "gui/session.h"

#include "capture.h"

#include <gtest/gtest.h>

#include <fstream>

namespace penumbra::gui {
namespace {

std::filesystem::path write(const Session &session, const std::string &name, const std::string &text) {
    const auto file = session.home() / name;
    std::ofstream(file) << text;
    return file;
}

constexpr const char *square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";

TEST(Files, ADroppedSceneIsOpened) {
    Session session;
    session.drop(write(session, "square one.obj", square));
    session.wait_until("the scene", [](const Json &s) { return s["scene"] == "square one"; });
    session.settled();
    EXPECT_EQ(session.state()["position"], 0);
    EXPECT_EQ(session.state()["message_is_error"], false);
}

TEST(Files, ABadDroppedFileIsOneLineAndTheOldSceneStays) {
    Session session;
    session.key("Right");
    session.wait_until("a step", [](const Json &s) { return s["position"] == 3 && !s["busy"]; });
    const Json before = session.settled();
    const Screenshot shot = session.shot();
    session.drop(write(session, "bad.obj", "v 0 0 0\nf 1 2 3\n"));
    const Json after = session.wait_until("the line", [](const Json &s) { return s["message_is_error"] == true; });
    const auto message = after["message"].get<std::string>();
    EXPECT_NE(message.find("bad.obj"), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    EXPECT_EQ(after["scene"], before["scene"]);
    EXPECT_EQ(after["panes"], before["panes"]);
    // It can be seen, over the panes.
    EXPECT_GT(share_of(session.shot(), session.widget("pane 0"), {142, 35, 27}, 25), 0.005);
    EXPECT_LT(share_of(shot, session.widget("pane 0"), {142, 35, 27}, 25), 0.001);
    // The next action takes it away.
    session.key("m");
    session.wait_until("no line", [](const Json &s) { return s["message_is_error"] == false; });
}

TEST(Files, APathIsTyped) {
    Session session;
    const auto file = write(session, "typed.obj", square);
    session.key("ctrl+o");
    session.wait_until("the dialog", [](const Json &s) { return s["open_dialog"] == true; });
    session.settled();
    session.type(file.string());
    session.enter();
    session.wait_until("the scene", [](const Json &s) { return s["scene"] == "typed"; });
}

TEST(Files, PicturesAreNumberedAndNeverOverwritten) {
    Session session;
    std::filesystem::create_directories(session.home() / ".config");
    std::ofstream(session.home() / ".config/user-dirs.dirs") << "XDG_PICTURES_DIR=\"$HOME/My Pictures\"\n";
    std::vector<std::string> files;
    for (const char *key : {"F12", "F12", "ctrl+F12"}) {
        const Json before = session.state();
        session.key(key);
        const Json after =
            session.wait_until(key, [&](const Json &s) { return s["picture"] != before["picture"]; });
        files.push_back(after["picture"]);
        EXPECT_TRUE(std::filesystem::exists(files.back()));
        EXPECT_EQ(std::filesystem::path(files.back()).parent_path(), session.home() / "My Pictures");
        EXPECT_NE(after["message"].get<std::string>().find(files.back()), std::string::npos);
    }
    const Image panes = read_png(files[0]), again = read_png(files[1]), window = read_png(files[2]);
    EXPECT_EQ(panes.rgb, again.rgb); // the same view gives the same picture
    EXPECT_GE(panes.width, 1280);
    EXPECT_EQ(window.width, 1280);
    EXPECT_EQ(window.height, 800);
    EXPECT_NE(read_png_state(files[0]).value_or("").find("figure-4"), std::string::npos);

    // With panels it is what the screen shows; without them it is not.
    const Screenshot shot = session.shot();
    const Box bar = session.widget("solve.play");
    double same = 0;
    for (int y = bar.y; y < bar.y + bar.height; ++y)
        for (int x = bar.x; x < bar.x + bar.width; ++x) {
            const std::size_t p = 3 * (static_cast<std::size_t>(y) * 1280 + static_cast<std::size_t>(x));
            same += shot.at(x, y) == Colour{window.rgb[p], window.rgb[p + 1], window.rgb[p + 2]};
        }
    EXPECT_GT(same / (bar.width * bar.height), 0.95);
}

TEST(Files, PicturesGoToPicturesOfTheHomeFolderOtherwise) {
    Session session;
    session.key("F12");
    const Json after = session.wait_until("a picture", [](const Json &s) { return s["picture"] != ""; });
    EXPECT_EQ(after["picture"], (session.home() / "Pictures/penumbra-1.png").string());
}

TEST(Files, AFolderThatCannotBeWrittenIsSaid) {
    Session session;
    std::ofstream(session.home() / "Pictures") << "a file where the folder should be";
    session.key("F12");
    session.wait_until("the line", [](const Json &s) { return s["message_is_error"] == true; });
    EXPECT_EQ(session.state()["picture"], "");
}

TEST(Files, NothingIsLeftInTheWorkingFolder) {
    Session session;
    session.key("Right");
    session.key("F12");
    session.wait_until("a picture", [](const Json &s) { return s["picture"] != ""; });
    session.key("ctrl+q");
    EXPECT_EQ(session.program().wait(10), 0);
    EXPECT_TRUE(std::filesystem::is_empty(session.folder()));
}

TEST(Files, NoDisplayIsStatusFive) {
    Process program({PENUMBRA_PROGRAM, "view"}, {{"DISPLAY", ""}, {"WAYLAND_DISPLAY", ""}}, "", "/dev/null");
    EXPECT_EQ(program.wait(20), 5);
}

TEST(Files, ABadFileOnTheCommandLineIsStatusThree) {
    Process program({PENUMBRA_PROGRAM, "view", "/nonexistent.obj"}, {{"DISPLAY", ""}}, "", "/dev/null");
    EXPECT_EQ(program.wait(20), 3);
}

} // namespace
} // namespace penumbra::gui
