// What one start leaves to the next: settings, recent files, and what was shown when it ended unexpectedly.
#include "gui/session.h"

#include <csignal>
#include <gmock/gmock.h>

#include <fstream>
#include <iterator>

namespace penumbra::gui {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path &file) {
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), {}};
}

Json json_of(const fs::path &file) { return Json::parse(text_of(file), nullptr, false); }

fs::path settings_of(const fs::path &home) { return home / ".config/penumbra/settings.json"; }

fs::path autosave_of(Session &session) {
    return session.home() / ".local/state/penumbra" / ("autosave-" + std::to_string(session.program().id()) + ".penumbra.json");
}

void quit(Session &session) {
    session.key("ctrl+q");
    EXPECT_EQ(session.program().wait(10), 0);
    EXPECT_TRUE(fs::is_empty(session.folder())) << "something was left in the working folder";
}

TEST(Settings, AreKept) {
    const Home home;
    Json first;
    {
        Session session({}, 1280, 800, {.home = home.path()});
        for (const char *key : {"ctrl+plus", "ctrl+plus", "shift+b"})
            session.key(key);
        const Box speed = session.widget("speed");
        session.drag({speed.x + 0.5 * speed.width, speed.y + 0.5 * speed.height},
                     {speed.x + 0.8 * speed.width, speed.y + 0.5 * speed.height});
        first = session.wait_until("another speed", [](const Json &s) { return s["speed"].get<double>() > 3; });
        first = session.settled();
        EXPECT_EQ(first["background"], "light");
        EXPECT_NEAR(first["ui_scale"].get<double>(), 1.125 * 1.125, 1e-12);
        quit(session);
    }
    Session session({}, 1280, 800, {.home = home.path()});
    const Json again = session.settled();
    for (const char *key : {"background", "ui_scale", "speed"})
        EXPECT_EQ(again[key], first[key]) << key;
}

TEST(Settings, AreWrittenWhileTheWindowIsOpen) {
    Session session;
    session.key("ctrl+plus");
    session.wait_until("the scale in the file", [&](const Json &) { return json_of(settings_of(session.home())).value("ui_scale", 0.0) == 1.125; });
}

TEST(Settings, TheThemeOfAStateWinsAndIsNotKept) {
    const Home home;
    const fs::path state = home.path() / "light.penumbra.json";
    std::ofstream(state) << R"({"scene": "furnace", "background": "light"})";
    {
        Session session({state.string()}, 1280, 800, {.home = home.path()});
        EXPECT_EQ(session.settled()["background"], "light");
        quit(session);
    }
    Session session({}, 1280, 800, {.home = home.path()});
    EXPECT_EQ(session.settled()["background"], "dark");
    session.drop(state);
    session.wait_until("the state", [](const Json &s) { return s["scene"] == "furnace" && s["background"] == "light"; });
}

TEST(Settings, BadOnesArePassedOverAndSaid) {
    const Home home;
    fs::create_directories(settings_of(home.path()).parent_path());
    std::ofstream(settings_of(home.path())) << R"({"ui_scale": "large", "tour_seen": true, "theme": "light"})";
    Session session({}, 1280, 800, {.home = home.path()});
    const Json s = session.settled();
    EXPECT_EQ(s["ui_scale"], 1.0);
    EXPECT_EQ(s["background"], "light") << "the good ones are taken";
    EXPECT_THAT(s["message"].get<std::string>(), testing::HasSubstr("settings.json: ui_scale"));
    EXPECT_EQ(s["message_is_error"], false);
    quit(session);
}

TEST(Settings, WhereNothingCanBeKeptTheWindowGoesOn) {
    const Home home;
    std::ofstream(home.path() / ".config") << "a file where the folder should be";
    std::ofstream(home.path() / ".local") << "a file where the folder should be";
    Session session({}, 1280, 800, {.first = true, .home = home.path()});
    session.key("ctrl+plus");
    session.wait_until("the reason", [](const Json &s) { return s["message"].get<std::string>().find("cannot make the folder") == 0; });
    session.key("Right");
    session.wait_until("a step", [](const Json &s) { return s["position"] == 3 && !s["busy"]; });
    quit(session);
}

TEST(Recent, FilesAreOfferedInMenuAndPalette) {
    const Home home;
    const fs::path folder = home.path() / "scenes";
    fs::create_directories(folder);
    for (const char *name : {"one.obj", "two.obj", "gone.obj"})
        std::ofstream(folder / name) << "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
    {
        Session session({(folder / "gone.obj").string()}, 1280, 800, {.home = home.path()});
        session.drop(folder / "one.obj");
        session.wait_until("one", [](const Json &s) { return s["scene"] == "one"; });
        session.click("scene");
        session.wait_until("the list", [](const Json &s) { return s["widgets"].contains("scene.furnace"); });
        session.settled();
        session.click("scene.furnace"); // a bundled one is not noted
        session.wait_until("furnace", [](const Json &s) { return s["scene"] == "furnace"; });
        session.drop(folder / "two.obj");
        const Json s = session.wait_until("two", [](const Json &now) { return now["scene"] == "two"; });
        EXPECT_EQ(s["recent"], (Json{folder / "two.obj", folder / "one.obj", folder / "gone.obj"}));
        quit(session);
    }
    EXPECT_EQ(json_of(home.path() / ".local/state/penumbra/recent.json")["files"].size(), 3U);
    fs::remove(folder / "gone.obj");
    Session session({}, 1280, 800, {.home = home.path()});
    session.click("menu.File");
    session.wait_until("the menu", [](const Json &s) { return s["widgets"].contains("menu.recent"); });
    session.settled();
    session.click("menu.recent");
    const Json open = session.wait_until("the list", [](const Json &s) { return s["widgets"].contains("menu.recent 1"); });
    EXPECT_FALSE(open["widgets"].contains("menu.recent 2")) << "the one that has gone is left out";
    session.settled();
    session.click("menu.recent 1");
    session.wait_until("one", [](const Json &s) { return s["scene"] == "one"; });
    session.settled();
    session.key("ctrl+k");
    session.wait_until("the palette", [](const Json &s) { return s["palette"] == true; });
    session.settled();
    session.type("two.obj");
    session.wait_until("found", [](const Json &s) { return s["found"] == "Open two.obj"; });
    session.enter();
    session.wait_until("two", [](const Json &s) { return s["scene"] == "two"; });
}

/// Another scene, two panes, seen from elsewhere, a step on; then the program is killed.
Json killed_view(const Home &home) {
    Session session({"skew-blockers", "--threshold", "0.05"}, 1280, 800, {.home = home.path()});
    for (const char *key : {"ctrl+2", "Right", "f", "c", "v"}) {
        session.key(key);
        session.settled();
    }
    const Json view = session.settled();
    session.wait_until("the autosave", [&](const Json &) {
        const Json kept = json_of(autosave_of(session));
        return kept.is_object() && kept["position"] == 3 && kept["false_colour"] == true && !kept["keyhole"].is_null();
    });
    EXPECT_EQ(::kill(session.program().id(), SIGKILL), 0);
    EXPECT_EQ(session.program().wait(10), 128 + SIGKILL);
    EXPECT_TRUE(fs::exists(autosave_of(session)));
    return view;
}

TEST(Autosave, WhatAKilledWindowShowedIsRestored) {
    const Home home;
    const Json view = killed_view(home);
    {
        Session session({}, 1280, 800, {.home = home.path()});
        const Json offered = session.settled();
        EXPECT_THAT(offered["offered"].get<std::string>(), testing::HasSubstr("autosave-"));
        EXPECT_EQ(offered["scene"], "figure-4") << "nothing is restored unasked";
        session.click("file.restore");
        session.wait_until("the scene", [](const Json &s) { return s["scene"] == "skew-blockers" && s["panes"].size() == 2; });
        session.wait_until("the step", [](const Json &s) { return s["panes"][0]["computed"] == 3 && s["panes"][1]["computed"] == 3; });
        const Json back = session.settled();
        for (const char *key : {"options", "position", "strategies", "layout", "active", "camera", "layers", "curves", "keyhole",
                                "shading", "exposure", "range", "false_colour", "background"})
            EXPECT_EQ(back[key], view[key]) << key;
        EXPECT_TRUE(back["offered"].is_null());
        EXPECT_TRUE(back["recent"].empty()) << "an autosave is no file of the user's";
        EXPECT_TRUE(fs::exists(autosave_of(session))) << "this window goes on with it";
        EXPECT_FALSE(fs::exists(offered["offered"].get<std::string>()));
        quit(session);
        EXPECT_TRUE(fs::is_empty(home.path() / ".local/state/penumbra")) << "a clean end leaves none";
    }
    Session session({}, 1280, 800, {.home = home.path()});
    EXPECT_TRUE(session.settled()["offered"].is_null());
}

TEST(Autosave, CanBeDiscarded) {
    const Home home;
    killed_view(home);
    {
        Session session({}, 1280, 800, {.home = home.path()}); // undecided: it is offered again
        EXPECT_FALSE(session.settled()["offered"].is_null());
        quit(session);
    }
    Session session({}, 1280, 800, {.home = home.path()});
    const Json before = session.settled();
    session.click("file.discard");
    session.wait_until("no offer", [](const Json &s) { return s["offered"].is_null(); });
    EXPECT_FALSE(fs::exists(before["offered"].get<std::string>()));
    EXPECT_EQ(session.settled()["scene"], before["scene"]);
}

TEST(Autosave, AWindowInWhichNothingWasDoneLeavesNone) {
    const Home home;
    {
        Session session({}, 1280, 800, {.home = home.path()});
        session.settled();
        ASSERT_EQ(::kill(session.program().id(), SIGKILL), 0);
        EXPECT_EQ(session.program().wait(10), 128 + SIGKILL);
    }
    Session session({}, 1280, 800, {.home = home.path()});
    EXPECT_TRUE(session.settled()["offered"].is_null());
}

} // namespace
} // namespace penumbra::gui
