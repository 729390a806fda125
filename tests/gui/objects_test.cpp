// Objects that are moved with the mouse, and what follows them.
#include "gui/session.h"

#include <gtest/gtest.h>

namespace penumbra::gui {
namespace {

class ObjectsTest : public testing::Test {
protected:
    Session session;

    void SetUp() override {
        session.key("End");
        session.wait_until("a solution", [](const Json &s) { return s["panes"][0].value("converged", false); });
        session.key("o");
        session.wait_until("the objects", [](const Json &s) { return s["widgets"].contains("object.blocker"); });
        session.settled();
    }
    Json choose(const std::string &name) {
        session.click("object." + name);
        return session.wait_until(name, [&](const Json &s) { return s["object"] == name; });
    }
    /// Drags the number beside a name.
    void drag_number(const std::string &name, double pixels) {
        const Point at = session.middle("object " + name);
        session.drag(at, {at.x + pixels, at.y});
        session.settled();
    }
};

TEST_F(ObjectsTest, APlaceThatIsDraggedMovesTheBlockerAndTheSolutionFollows) {
    const Json before = choose("blocker");
    drag_number("centre x", 60);
    const Json after = session.wait_until("a move", [](const Json &s) { return s["moves"].size() == 1; });
    EXPECT_GT(after["moves"][0]["offset"][0].get<double>(), 0);
    EXPECT_EQ(after["moves"][0]["offset"][1], 0.0);
    EXPECT_NE(after["run"], before["run"]);
    EXPECT_EQ(after["panes"][0]["converged"], true);
    EXPECT_NE(after["panes"][0]["version"], before["panes"][0]["version"]);
    session.key("ctrl+z");
    const Json back = session.wait_until("nothing moved", [](const Json &s) { return s["moves"].empty(); });
    session.settled();
    session.key("ctrl+y");
    EXPECT_EQ(session.wait_until("moved again", [](const Json &s) { return s["moves"].size() == 1; })["moves"], after["moves"]);
}

TEST_F(ObjectsTest, TheSizeIsTimesTheFilesOwn) {
    choose("blocker");
    drag_number("size", 40);
    const Json after = session.wait_until("a move", [](const Json &s) { return s["moves"].size() == 1; });
    EXPECT_GT(after["moves"][0]["scale"].get<double>(), 1);
    EXPECT_EQ(after["moves"][0]["offset"], (Json{0.0, 0.0, 0.0}));
    session.click("edit.put_back");
    session.wait_until("nothing moved", [](const Json &s) { return s["moves"].empty(); });
}

TEST_F(ObjectsTest, AnObjectInHandFollowsTheMouseInAPane) {
    const Json before = choose("blocker");
    const Box pane = session.widget("pane 0");
    // The blocker lies at the right of the floor in the paper's scene.
    const Point at{pane.x + 0.75 * pane.width, pane.y + 0.55 * pane.height};
    session.click(at);
    session.wait_until("the blocker in hand", [](const Json &s) { return s["object"] == "blocker"; });
    session.drag(at, {at.x + 40, at.y});
    const Json after = session.wait_until("a move", [](const Json &s) { return s["moves"].size() == 1; });
    EXPECT_EQ(after["camera"], before["camera"]) << "the view stays while an object is held";
    EXPECT_NEAR(after["moves"][0]["offset"][2].get<double>(), 0, 1e-9) << "level with the floor";
    session.settled();
    const Json settled = session.state();
    session.drag({at.x + 40, at.y}, {at.x + 40, at.y - 30}, 1, "shift");
    session.wait_until("higher", [&](const Json &s) {
        return s["moves"].size() == 1 && s["moves"][0]["offset"][2].get<double>() > 0;
    });
    EXPECT_EQ(session.state()["camera"], before["camera"]);
}

TEST_F(ObjectsTest, AStateKeepsWhatWasMoved) {
    choose("blocker");
    drag_number("centre x", 60);
    session.settled();
    session.key("ctrl+s");
    const Json saved = session.wait_until("a file", [](const Json &s) { return s["saved"] != ""; });
    session.click("edit.put_back");
    session.wait_until("nothing moved", [](const Json &s) { return s["moves"].empty(); });
    session.settled();
    session.drop(saved["saved"].get<std::string>());
    const Json again = session.wait_until("moved as saved", [](const Json &s) { return s["moves"].size() == 1; });
    EXPECT_EQ(again["moves"], saved["moves"]);
    session.settled();
    session.key("shift+o");
    session.wait_until("as the file has it", [](const Json &s) { return s["moves"].empty(); });
}

} // namespace
} // namespace penumbra::gui
