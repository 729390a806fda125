// Buttons, sliders and menus, with the mouse.
#include "gui/session.h"

#include <gtest/gtest.h>

namespace penumbra::gui {
namespace {

class PanelsTest : public testing::Test {
protected:
    Session session;
    /// Clicks and waits for it.
    Json click(const std::string &widget, const std::function<bool(const Json &)> &holds) {
        EXPECT_FALSE(holds(session.state())) << widget << ": holds already, the click would prove nothing";
        session.click(widget);
        session.wait_until(widget, holds);
        return session.settled();
    }
};

TEST_F(PanelsTest, TransportButtons) {
    click("solve.step", [](const Json &s) { return s["panes"][0].value("iteration", 0) == 1; });
    click("solve.sub_step", [](const Json &s) { return s["position"] == 4; });
    click("solve.back", [](const Json &s) { return s["position"] == 3; });
    click("solve.reset", [](const Json &s) { return s["position"] == 0; });
    click("solve.play", [](const Json &s) { return s["playing"] == true; });
    click("solve.end", [](const Json &s) { return s["panes"][0].value("converged", false); });
}

TEST_F(PanelsTest, AClickOnTheCourseGoesThere) {
    click("solve.step", [](const Json &s) { return s["position"] == 3; });
    const Box course = session.widget("course");
    session.click(Point{course.x + 9.0, course.y + 0.36 * course.height});
    session.wait_until("the start", [](const Json &s) { return s["position"] == 0; });
}

TEST_F(PanelsTest, PlayingGoesOnByItselfUntilConverged) {
    session.click("solve.play");
    session.wait_until("the first step", [](const Json &s) { return s["position"].get<int>() >= 3; });
    session.wait_until("the end", [](const Json &s) { return s["playing"] == false; }, 60);
    EXPECT_EQ(session.state()["panes"][0]["converged"], true);
}

TEST_F(PanelsTest, StrategyTogglesAreMeshingTimesBasis) {
    const auto shows = [](const char *name) { return [name](const Json &s) { return s["strategies"][0] == name; }; };
    click("basis.constant", shows("discontinuity-constant"));
    click("meshing.uniform", shows("uniform-constant"));
    click("basis.multiwavelet", shows("uniform-wavelet"));
    click("meshing.discontinuity", shows("discontinuity-wavelet"));
}

TEST_F(PanelsTest, EachPaneHasAStrategyOfItsOwn) {
    click("view.two", [](const Json &s) { return s["layout"] == "two"; });
    const Json two = session.state();
    EXPECT_NE(two["strategies"][0], two["strategies"][1]);
    click("pane 0", [](const Json &s) { return s["active"] == 0; });
    const Json before = session.state();
    session.key("3");
    const Json after = session.wait_until("(c)", [](const Json &s) { return s["strategies"][0] == "uniform-wavelet"; });
    EXPECT_EQ(after["strategies"][1], before["strategies"][1]);
    click("view.four", [](const Json &s) { return s["layout"] == "four"; });
    click("view.single", [](const Json &s) { return s["layout"] == "single"; });
}

TEST_F(PanelsTest, LinkedPanesStandAtTheSameStep) {
    click("view.four", [](const Json &s) { return s["layout"] == "four"; });
    session.key("Right");
    session.wait_until("a step of all", [](const Json &s) {
        for (const Json &pane : s["panes"])
            if (pane.value("iteration", 0) != 1 || pane["phase"] != s["panes"][0]["phase"])
                return false;
        return s["panes"].size() == 4;
    });
}

TEST_F(PanelsTest, CheckBoxes) {
    click("layers.mesh", [](const Json &s) { return s["layers"]["mesh"] == false; });
    click("layers.curves", [](const Json &s) { return s["layers"]["curves"] == false; });
    click("layers.links", [](const Json &s) { return s["layers"]["links"] == true; });
    click("layers.flat", [](const Json &s) { return s["shading"] == "flat"; });
    click("layers.linear", [](const Json &s) { return s["shading"] == "linear"; });
    click("layers.polynomial", [](const Json &s) { return s["shading"] == "polynomial"; });
    click("layers.false_colour", [](const Json &s) { return s["false_colour"] == true; });
}

TEST_F(PanelsTest, SlidersOfTheSolutionStartItAnew) {
    click("solve.step", [](const Json &s) { return s["position"] == 3; });
    for (const auto &[slider, option] :
         {std::pair<std::string, std::string>{"threshold", "threshold"}, {"depth", "max_depth"}}) {
        SCOPED_TRACE(slider);
        const Json before = session.state();
        const Box box = session.widget(slider);
        const double y = box.y + 0.5 * box.height;
        session.drag({box.x + 0.5 * box.width, y}, {box.x + 0.3 * box.width, y});
        session.wait_until("another " + option, [&](const Json &s) {
            return s["options"][option] != before["options"][option] && s["run"] != before["run"];
        });
        const Json after = session.settled();
        EXPECT_NE(after["panes"][0]["version"], before["panes"][0]["version"]);
        EXPECT_EQ(after["position"], before["position"]); // solved again up to the same step
    }
}

TEST_F(PanelsTest, TheOrderStartsItAnew) {
    const Json before = session.state();
    click("order 2", [](const Json &s) { return s["options"]["order"] == 2; });
    EXPECT_NE(session.state()["run"], before["run"]);
    EXPECT_EQ(session.state()["panes"][0]["coefficients"].get<int>(),
              4 * session.state()["panes"][0]["patches"].get<int>());
}

TEST_F(PanelsTest, TheBasisStartsItAnew) {
    const Json before = session.state();
    click("basis planar", [](const Json &s) { return s["options"]["basis"] == "planar"; });
    EXPECT_NE(session.state()["run"], before["run"]);
    EXPECT_EQ(session.state()["panes"][0]["coefficients"].get<int>(),
              10 * session.state()["panes"][0]["patches"].get<int>());
}

TEST_F(PanelsTest, ExposureSlider) {
    const Box box = session.widget("exposure");
    const double y = box.y + 0.5 * box.height;
    session.drag({box.x + 0.5 * box.width, y}, {box.x + 0.7 * box.width, y});
    session.wait_until("an exposure", [](const Json &s) { return s["exposure"].get<double>() > 1; });
}

TEST_F(PanelsTest, Menus) {
    session.click("menu.Layers");
    session.wait_until("the menu", [](const Json &s) { return s["widgets"].contains("menu.layers.mesh"); });
    session.settled();
    click("menu.layers.mesh", [](const Json &s) { return s["layers"]["mesh"] == false; });
}

TEST_F(PanelsTest, ScenesOfTheToolBar) {
    session.click("scene");
    session.wait_until("the list", [](const Json &s) { return s["widgets"].contains("scene.furnace"); });
    session.settled();
    click("scene.furnace", [](const Json &s) { return s["scene"] == "furnace"; });
    EXPECT_EQ(session.state()["position"], 0);
}

TEST_F(PanelsTest, TheMouseTellsWhatIsUnderIt) {
    const Box pane = session.widget("pane 0");
    session.move({pane.x + 0.4 * pane.width, pane.y + 0.72 * pane.height});
    session.wait_until("a surface", [](const Json &s) {
        return s["under_cursor"].is_object() && s["under_cursor"]["surface"] == 0;
    });
    session.move({pane.x + 0.02 * pane.width, pane.y + 0.5 * pane.height});
    session.wait_until("nothing", [](const Json &s) { return s["under_cursor"].is_null(); });
}

} // namespace
} // namespace penumbra::gui
