// Twice as large, for a projector: everything fits into a window of 1280 by 720, or can be scrolled to.
#include "gui/session.h"

#include <gtest/gtest.h>

#include <fstream>
#include <map>

namespace penumbra::gui {
namespace {

constexpr int width = 1280, height = 720;

std::filesystem::path twice_as_large(const Home &home) {
    const auto settings = home.path() / ".config/penumbra/settings.json";
    std::filesystem::create_directories(settings.parent_path());
    std::ofstream(settings) << R"({"tour_seen": true, "ui_scale": 2})";
    return home.path();
}

class TwiceAsLarge : public testing::Test {
protected:
    explicit TwiceAsLarge(const std::string &asked = "--threshold") : session({"figure-4", asked, "0.05"}, width, height, {.home = twice_as_large(home)}) {}

    Home home;
    Session session;

    void SetUp() override {
        session.resize(width, height);
        session.key("Right");
        session.wait_until("a step", [](const Json &s) { return s["position"] == 3 && !s["busy"]; });
        ASSERT_EQ(session.settled()["ui_scale"], 2);
    }

    void expect_whole(const std::string &what) {
        SCOPED_TRACE(what);
        const Json s = session.settled();
        EXPECT_EQ(s["cut"], Json::array());
        for (const auto &[name, r] : s["widgets"].items()) {
            EXPECT_GE(r[0], -1) << name;
            EXPECT_LE(r[0].get<double>() + r[2].get<double>(), width + 1) << name;
        }
    }

    /// Opens it, looks, and closes it again.
    void look(const std::string &key, const std::string &what) {
        session.key(key);
        expect_whole(what);
        session.key(key);
        session.settled();
    }
};

TEST_F(TwiceAsLarge, TheBarsAndTheSidePanelAreWhole) {
    expect_whole("the window");
    for (const char *name : {"menu.File", "menu.Help", "scene", "basis.multiwavelet", "view.four", "view.cost", "help.keys",
                             "solve.reset", "view.before", "course", "speed"}) {
        const Box box = session.widget(name);
        EXPECT_GE(box.y, 0) << name;
        EXPECT_LE(box.y + box.height, height) << name;
    }
    // Nothing lies over what is beside it.
    EXPECT_LE(session.widget("view.before").x + session.widget("view.before").width, session.widget("speed").x);
    look("x", "errors");
}

TEST(AsLargeAsUsual, NothingIsCutOff) {
    Session session;
    EXPECT_EQ(session.settled()["cut"], Json::array());
    for (const char *key : {"Right", "ctrl+4", "x"}) {
        session.key(key);
        EXPECT_EQ(session.settled()["cut"], Json::array()) << key;
    }
}

class TwiceAsLargeByTolerance : public TwiceAsLarge {
protected:
    TwiceAsLargeByTolerance() : TwiceAsLarge("--tolerance") {}
};

TEST_F(TwiceAsLargeByTolerance, TheSidePanelIsWhole) { expect_whole("the window"); }

TEST_F(TwiceAsLarge, TheInspectorsAreWhole) {
    const std::map<std::string, std::string> inspectors{{"t", "filters"},   {"h", "hard cases"}, {"a", "cost"},
                                                        {"y", "effects"},   {"o", "objects"},    {"ctrl+shift+b", "bookmarks"}};
    for (const auto &[key, what] : inspectors)
        look(key, what);
    session.take_first_object();
    expect_whole("an object");
    session.key("ctrl+b");
    look("ctrl+shift+b", "a bookmark");
    session.key("i");
    session.wait_until("the inspector", [](const Json &s) { return s["inspector"] == "element"; });
    const Box pane = session.widget("pane 0");
    session.click(Point{pane.x + 0.5 * pane.width, pane.y + 0.5 * pane.height});
    session.wait_until("an element", [](const Json &s) { return s["inspected"].contains("links") && !s["busy"]; });
    expect_whole("an element");
}

TEST_F(TwiceAsLarge, WhatOpensOverTheSceneIsWhole) {
    look("question", "help");
    session.key("ctrl+o");
    expect_whole("the dialog of files");
    session.key("Escape");
    session.key("ctrl+k");
    expect_whole("the palette");
    session.type("picture settings");
    session.enter();
    session.wait_until("the picture settings", [](const Json &s) { return s["pictures"]["settings_open"] == true; });
    expect_whole("the picture settings");
    session.key("Escape");
    for (const char *menu : {"File", "Edit", "Solve", "Strategy", "View", "Layers", "Help"}) {
        session.click(std::string("menu.") + menu);
        expect_whole(menu);
        session.click(Point{1000, 20}); // beside the menus: closes it
        session.settled();
    }
    session.key("shift+F1");
    for (int card = 0; card < 6; ++card) {
        session.wait_until("the card", [&](const Json &s) { return s["tour"]["open"] == true && s["tour"]["card"] == card; });
        expect_whole("card " + std::to_string(card));
        session.click("tour.next");
    }
    session.key("shift+F1");
}

TEST_F(TwiceAsLarge, TheKeyholeAndTheProfileAreWhole) {
    look("v", "the keyhole");
    session.key("s");
    session.wait_until("the profile", [](const Json &s) { return s["profiling"]["open"] == true && !s["busy"]; }, 60);
    expect_whole("the profile");
    session.key("s");
    session.key("ctrl+4");
    session.wait_until("four panes", [](const Json &s) { return s["panes"].size() == 4 && !s["busy"]; });
    expect_whole("four panes");
}

/// A window in which nothing can be whole, and it is seen.
TEST_F(TwiceAsLarge, ASmallWindowIsSeenToCut) {
    session.resize(420, 300);
    session.wait_until("cuts", [](const Json &s) { return s["cut"].size() > 2; });
}

} // namespace
} // namespace penumbra::gui
