// The ledger of effects in the window: decisions, switches, and what they change.
#include "gui/session.h"

#include <gtest/gtest.h>

namespace penumbra::gui {
namespace {

class EffectsTest : public testing::Test {
protected:
    EffectsTest() : session({"cornell-box"}, 1400, 900) {
        session.key("y");
        session.wait_until("the ledger", [](const Json &s) { return s["inspector"] == "effects"; });
        session.key("End");
        solved();
    }
    Json solved() {
        return session.wait_until("a solution", [](const Json &s) { return s["panes"][0].value("converged", false); });
    }
    Session session;
};

TEST_F(EffectsTest, ASwitchIsTakenAndGivenBackToTheScene) {
    const int whole = session.state()["panes"][0]["patches"];
    session.click("effect visibility off");
    session.wait_until("switched", [](const Json &s) { return s["options"]["effects"].value("visibility", "") == "off"; });
    // It goes to its end again, by itself: without shadows the mesh is another one.
    session.wait_until("other patches", [&](const Json &s) {
        return s["panes"][0].value("converged", false) && s["panes"][0]["patches"] != whole;
    });
    session.click("effects.by_scene");
    session.wait_until("as before", [&](const Json &s) {
        return s["options"]["effects"].empty() && s["panes"][0].value("converged", false) && s["panes"][0]["patches"] == whole;
    });
}

TEST_F(EffectsTest, WhatAnEffectChangesIsShownInPlaceOfTheLight) {
    session.settled();
    const Screenshot light = session.shot();
    const Box pane = session.widget("pane 0");
    session.click("change visibility");
    const Json s = session.wait_until("the change", [](const Json &now) {
        return now["panes"][0].contains("error") && !now["panes"][0]["error"].is_null() && !now["judging"]["busy"];
    });
    EXPECT_EQ(s["error"]["change"], "visibility=off");
    EXPECT_EQ(s["shading"], "error");
    EXPECT_GT(s["panes"][0]["error"], 0.1) << "shadows of the blocks are a good part of this light";
    EXPECT_GT(changed_share(light, session.shot(), pane), 0.05);
    session.click("change visibility");
    session.wait_until("the light", [](const Json &now) { return now["shading"] == "polynomial" && now["error"]["change"].is_null(); });
}

} // namespace
} // namespace penumbra::gui
