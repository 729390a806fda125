// Error pictures in the window: measured off its thread, on one scale, which can be locked.
#include "gui/session.h"

#include <gtest/gtest.h>

#include <cmath>

namespace penumbra::gui {
namespace {

bool all_measured(const Json &s) {
    for (const Json &pane : s["panes"])
        if (!pane.contains("error") || pane["error"].is_null())
            return false;
    return !s["judging"]["busy"] && !s["error"]["range"].is_null();
}

TEST(Errors, ArePicturedInAllPanesOnOneScale) {
    Session session({"slanted-edge"});
    session.key("ctrl+2");
    session.key("Right");
    session.wait_until("a step", [](const Json &s) {
        return s["panes"].size() == 2 && s["panes"][0].value("computed", 0) >= 3 &&
               s["panes"][1].value("computed", 0) >= 3;
    });
    session.key("m");
    session.key("d");
    const Screenshot light = session.shot();
    session.key("x");
    const Json first = session.wait_until("the errors", all_measured);
    EXPECT_EQ(first["shading"], "error");
    EXPECT_EQ(first["error"]["kind"], "signed");
    EXPECT_EQ(first["judging"]["truth_error"], 0) << "light bounces once: exact";
    EXPECT_DOUBLE_EQ(first["error"]["range"][0].get<double>(), -first["error"]["range"][1].get<double>());
    const Box pane = session.widget("pane 0");
    EXPECT_GT(changed_share(light, session.shot(), pane), 0.05);
    // By name, each kind; the scale follows.
    for (const char *kind : {"relative", "patch", "estimate", "signed"}) {
        session.click("error." + std::string(kind));
        const Json now =
            session.wait_until(kind, [&](const Json &s) { return s["error"]["kind"] == kind && all_measured(s); });
        const double low = now["error"]["range"][0], high = now["error"]["range"][1];
        EXPECT_LT(low, high);
        EXPECT_EQ(std::string(kind) == "signed", low < 0);
        if (std::string(kind) == "estimate") {
            EXPECT_NEAR(low * high, 1, 1e-9);
        }
    }
    // A kind's picture is its own.
    const Screenshot signed_picture = session.shot();
    session.click("error.patch");
    session.wait_until("the patches", [&](const Json &s) { return s["error"]["kind"] == "patch" && all_measured(s); });
    EXPECT_GT(changed_share(signed_picture, session.shot(), pane), 0.05);
    session.key("p");
    session.wait_until("the light again", [](const Json &s) { return s["shading"] == "polynomial"; });
    session.move({1.0 * pane.x + 3, pane.y + 300.0});
    EXPECT_LT(changed_share(light, session.shot(), pane), 0.02);
}

TEST(Errors, ScaleFollowsTheStepsUnlessItIsLocked) {
    Session session({"slanted-edge", "--strategy", "uniform-wavelet", "--threshold", "0.005"});
    session.key("x");
    session.key("Right");
    const auto at = [&](int position) {
        return session.wait_until("measured", [&](const Json &s) {
            return s["panes"][0].value("computed", 0) >= position && s["position"] == position && all_measured(s);
        });
    };
    const Json first = at(3);
    session.key("Right");
    session.key("Right");
    const Json later = at(9);
    EXPECT_LT(later["panes"][0]["error"].get<double>(), first["panes"][0]["error"].get<double>());
    EXPECT_LT(later["error"]["range"][1].get<double>(), first["error"]["range"][1].get<double>())
        << "the scale followed";
    session.key("Home");
    session.key("Right");
    at(3);
    session.settled();
    session.key("k");
    session.wait_until("locked", [](const Json &s) { return s["error"]["locked"] == true; });
    const Json range = session.state()["error"]["range"];
    session.key("Right");
    session.key("Right");
    at(9);
    EXPECT_EQ(session.settled()["error"]["range"], range);
}

TEST(Errors, OfABouncingSceneWaitForAReferenceAndEscapeStopsIt) {
    Session session({"cornell-box"});
    session.key("Right");
    session.wait_until(
        "a step", [](const Json &s) { return s["panes"][0].value("computed", 0) >= 3; }, 120);
    session.key("x");
    session.wait_until("the reference", [](const Json &s) { return s["judging"]["busy"] == true; });
    session.key("Escape");
    const Json stopped = session.wait_until("it stops", [](const Json &s) { return s["judging"]["halted"] == true; });
    EXPECT_EQ(stopped["judging"]["busy"], false);
    EXPECT_TRUE(stopped["panes"][0]["error"].is_null());
    // The window has answered at once, and goes on answering.
    session.key("m");
    session.wait_until(
        "the mesh", [](const Json &s) { return s["layers"]["mesh"] == false; }, 5);
}

} // namespace
} // namespace penumbra::gui
