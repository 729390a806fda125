// Views that are kept and come back to, with a clicker's keys.
#include "gui/session.h"

#include <gtest/gtest.h>

#include <fstream>

namespace penumbra::gui {
namespace {

class BookmarksTest : public testing::Test {
protected:
    Session session;

    Json keep(std::size_t n) {
        session.key("ctrl+b");
        session.wait_until("bookmark " + std::to_string(n), [&](const Json &s) { return s["bookmarks"].size() == n; });
        return session.settled();
    }
};

TEST_F(BookmarksTest, AClickerGoesFromOneToTheNextAndBack) {
    session.key("Right");
    session.wait_until("a step", [](const Json &s) { return s["panes"][0].value("iteration", 0) == 1; });
    const Json first = keep(1);
    session.key("ctrl+2");
    session.key("f");
    session.key("x");
    session.key("End");
    session.wait_until("an end", [](const Json &s) { return s["panes"].size() == 2 && s["panes"][0].value("converged", false); });
    const Json second = keep(2);
    session.key("Prior");
    const Json back = session.wait_until("the first", [](const Json &s) { return s["bookmark"] == 0 && s["layout"] == "single"; });
    for (const char *what : {"position", "strategies", "camera", "shading"})
        EXPECT_EQ(back[what], first[what]) << what;
    EXPECT_EQ(back["run"], first["run"]) << "what was computed stays";
    EXPECT_EQ(back["caption"], first["bookmarks"][0]["caption"]);
    session.key("Next");
    const Json again = session.wait_until("the second", [](const Json &s) { return s["bookmark"] == 1 && s["layout"] == "two"; });
    for (const char *what : {"position", "strategies", "camera", "shading"})
        EXPECT_EQ(again[what], second[what]) << what;
    session.key("Next");
    EXPECT_EQ(session.settled()["bookmark"], 1) << "there is no third";
}

TEST_F(BookmarksTest, OtherScenesAndOptionsComeBackToo) {
    session.click("order 2");
    session.wait_until("order 2", [](const Json &s) { return s["options"]["order"] == 2; });
    session.settled();
    keep(1);
    session.click("scene");
    session.wait_until("the list", [](const Json &s) { return s["widgets"].contains("scene.stairs"); });
    session.settled();
    session.click("scene.stairs");
    session.wait_until("stairs", [](const Json &s) { return s["scene"] == "stairs"; });
    session.settled();
    session.click("order 3");
    session.wait_until("order 3", [](const Json &s) { return s["options"]["order"] == 3; });
    session.settled();
    keep(2);
    session.key("Prior");
    session.wait_until("the first scene", [](const Json &s) { return s["scene"] == "figure-4" && s["options"]["order"] == 2; });
    session.settled();
    session.key("Next");
    session.wait_until("the second", [](const Json &s) { return s["scene"] == "stairs" && s["options"]["order"] == 3; });
}

TEST_F(BookmarksTest, AStateKeepsThemWithTheirCaptions) {
    keep(1);
    session.key("ctrl+shift+b");
    session.wait_until("the list", [](const Json &s) { return s["widgets"].contains("caption 1"); });
    session.settled();
    session.click("caption 1");
    session.key("End");
    session.type(" now");
    session.wait_until("another caption", [](const Json &s) {
        return s["bookmarks"][0]["caption"].get<std::string>().ends_with(" now");
    });
    session.enter();
    session.settled();
    session.key("ctrl+s");
    const Json saved = session.wait_until("a file", [](const Json &s) { return s["saved"] != ""; });
    session.click("no bookmark 1");
    session.wait_until("none", [](const Json &s) { return s["bookmarks"].empty(); });
    session.settled();
    session.drop(saved["saved"].get<std::string>());
    const Json again = session.wait_until("one", [](const Json &s) { return s["bookmarks"].size() == 1; });
    EXPECT_EQ(again["bookmarks"], saved["bookmarks"]);
}

TEST_F(BookmarksTest, WhatCannotBeIsToldAndTheWindowStays) {
    keep(1);
    session.key("ctrl+s");
    const Json saved = session.wait_until("a file", [](const Json &s) { return s["saved"] != ""; });
    Json state = Json::parse(std::ifstream(saved["saved"].get<std::string>()));
    state["bookmarks"][0]["moves"] = Json::array({{{"surface", 99}, {"offset", {0, 0, 1}}, {"scale", 1}}});
    const auto file = session.folder() / "impossible.penumbra.json";
    std::ofstream(file) << state.dump();
    session.drop(file);
    session.wait_until("the state", [](const Json &s) { return s["opening"] == "" && s["bookmarks"][0]["moves"].size() == 1; });
    session.settled();
    session.key("Next");
    session.wait_until("the next of them", [](const Json &s) { return s["message_is_error"] == true; });
    EXPECT_NE(session.state()["message"].get<std::string>().find("surface 99"), std::string::npos);
    EXPECT_TRUE(session.state()["moves"].empty());
    session.key("m");
    session.wait_until("still a window", [](const Json &s) { return s["layers"]["mesh"] == false; });
}

} // namespace
} // namespace penumbra::gui
