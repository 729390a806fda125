// What is on the screen, read from the display's memory: that layers, shadings and labels are really drawn.
#include "gui/session.h"

#include <gtest/gtest.h>

namespace penumbra::gui {
namespace {

class ShownTest : public testing::Test {
protected:
    ShownTest() {
        session.key("Right");
        session.wait_until("a step", [](const Json &s) { return s["panes"][0]["iteration"] == 1 && !s["busy"]; });
        session.key("n"); // no passing highlight
        session.settled();
        before = session.shot();
        pane = session.widget("pane 0");
    }
    /// Share of the pane that the key changes.
    double change_by(const std::string &key) {
        before = session.shot();
        session.key(key);
        return changed_share(before, session.shot(), pane);
    }

    Session session;
    Screenshot before;
    Box pane;
};

TEST_F(ShownTest, TheFirstPictureShowsTheScene) {
    // A lit floor is brighter than the background that surrounds it.
    const Box middle{pane.x + pane.width / 3, pane.y + pane.height / 2, pane.width / 3, pane.height / 4};
    const Box corner{pane.x + pane.width - 40, pane.y + pane.height - 60, 30, 30};
    EXPECT_GT(brightness(before, middle), brightness(before, corner) + 20);
}

TEST_F(ShownTest, NothingChangesByItself) {
    session.settled();
    EXPECT_EQ(changed_share(before, session.shot(), pane), 0);
}

TEST_F(ShownTest, MeshAndCurvesAppearAndGo) {
    session.key("1"); // many patches
    session.key("End");
    session.wait_until("the end", [](const Json &s) { return s["panes"][0].value("converged", false); }, 120);
    const double mesh = change_by("m");
    EXPECT_GT(mesh, 0.003);
    EXPECT_LT(mesh, 0.5);
    const double curves = change_by("d");
    EXPECT_GT(curves, 0.0005);
    EXPECT_LT(curves, 0.2);
}

TEST_F(ShownTest, ShadingsDiffer) {
    EXPECT_GT(change_by("p"), 0.05); // flat
    EXPECT_GT(change_by("p"), 0.05); // linear
    EXPECT_GT(change_by("p"), 0.05); // polynomial
    EXPECT_GT(change_by("c"), 0.1);  // false colour
}

TEST_F(ShownTest, ExposureBrightensTheScene) {
    const auto at_exposure = [&](const std::string &key, double exposure) {
        for (int i = 0; i < 12 && session.state()["exposure"] != exposure; ++i)
            session.key(key);
        session.wait_until("the exposure", [&](const Json &s) { return s["exposure"] == exposure; });
        return brightness(session.shot(), pane);
    };
    const double dark = at_exposure("shift+e", -2);
    EXPECT_GT(at_exposure("e", 2), dark + 5);
}

TEST_F(ShownTest, StrategiesAreSideBySide) {
    session.key("ctrl+4");
    session.wait_until("four panes", [](const Json &s) { return s["panes"].size() == 4; });
    session.key("End");
    const Json state = session.wait_until("four solutions", [](const Json &s) {
        for (const Json &p : s["panes"])
            if (!p.value("converged", false))
                return false;
        return true;
    }, 120);
    EXPECT_GT(state["panes"][0]["patches"].get<int>(), state["panes"][2]["patches"].get<int>());
    EXPECT_GT(state["panes"][2]["patches"].get<int>(), state["panes"][3]["patches"].get<int>());
    // The first and the last hold the same scene on meshes that differ, at the same place.
    const Screenshot shot = session.shot();
    const Box a = session.widget("pane 0"), d = session.widget("pane 3");
    ASSERT_EQ(a.width, d.width);
    double differing = 0;
    for (int y = a.height / 3; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x)
            differing += shot.at(a.x + x, a.y + y) != shot.at(d.x + x, d.y + y);
    EXPECT_GT(differing / (a.width * a.height), 0.01);
}

TEST_F(ShownTest, HiddenPanelsGiveTheirRoomToTheScene) {
    session.key("F11");
    session.wait_until("no panels", [](const Json &s) { return s["panels_hidden"] == true; });
    session.settled();
    const Box now = session.widget("pane 0");
    EXPECT_EQ(now.x, 0);
    EXPECT_EQ(now.y, 0);
    EXPECT_EQ(now.width, 1280);
    EXPECT_GT(now.height, pane.height);
}

TEST_F(ShownTest, TheHintIsThereUntilTheFirstStep) {
    const Colour hint{240, 195, 100};
    EXPECT_LT(share_of(session.shot(), pane, hint, 20), 0.001);
    Session fresh;
    EXPECT_EQ(fresh.state()["hint"], true);
    EXPECT_EQ(fresh.state()["position"], 0);
    EXPECT_EQ(fresh.state()["scene"], "figure-4");
    EXPECT_GT(share_of(fresh.shot(), fresh.widget("pane 0"), hint, 20), 0.01);
}

} // namespace
} // namespace penumbra::gui
