// The inspector of an element in the window: what it tells is what a solver of our own tells, its links are drawn and
// X-rayed, and it follows steps and strategies.
#include "gui/session.h"

#include "iteration/element_report.h"
#include "iteration/solver.h"
#include "iteration/state.h"
#include "render/camera.h"
#include "scene/bundled.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

namespace penumbra::gui {
namespace {

/// A point of the floor in half shadow, where elements are small.
const Vec2 spot(0.1, 0.1);

class ElementTest : public testing::Test {
protected:
    explicit ElementTest(BasisFamily basis = BasisFamily::parametric)
        : session({"skew-blockers", "--threshold", "0.02", "--basis", std::string(name(basis))}), scene(std::make_shared<const Scene>(open_scene("skew-blockers"))) {
        options.basis = basis;
        for (int k = 0; k < 2; ++k)
            session.key("Right");
        session.wait_until("two steps", [](const Json &s) { return s["panes"][0].value("computed", 0) >= 6 && !s["busy"]; });
        session.key("i");
        session.wait_until("the inspector", [](const Json &s) { return s["inspector"] == "element"; });
        session.settled();
    }

    static Vec3 vector(const Json &v) { return {v[0].get<double>(), v[1].get<double>(), v[2].get<double>()}; }
    Point on_screen(const Vec3 &p) {
        const Json c = session.state()["camera"];
        const auto glm_of = [](const Vec3 &v) { return glm::dvec3(v.x(), v.y(), v.z()); };
        const Camera camera{glm_of(vector(c["eye"])), glm_of(vector(c["target"])), glm_of(vector(c["up"])), c["fov"].get<double>()};
        const Box pane = session.widget("pane 0");
        const auto at = place_in_frame(camera, static_cast<double>(pane.width) / pane.height, glm_of(p));
        return {pane.x + (0.5 + 0.5 * at->x) * pane.width, pane.y + (0.5 - 0.5 * at->y) * pane.height};
    }
    /// Of a solver of our own after so many phases, about the element that the window has picked.
    ElementReport own_report(Strategy strategy, int phases, const Json &told) const {
        Options o = options;
        o.strategy = strategy;
        Solver solver(scene, o);
        for (int k = 0; k < phases; ++k)
            solver.sub_step();
        const Element &e = solver.state()->forest[ElementId(told["element"].get<int>())];
        const Vec3 at = scene->own.to_own(scene->surface(e.surface).frame.to_space(e.basis.centre()));
        return *solver.inspect(*solver.state(), {e.surface.index, at, {}, XrayLine::centre});
    }
    static bool answered(const Json &s) { return s["inspected"]["awaited"] == false && s["inspected"].contains("heading"); }
    void expect_told(const Json &told, const ElementReport &own) const {
        EXPECT_EQ(told["heading"], heading(own));
        EXPECT_EQ(told["history"].get<std::vector<std::string>>(), history_words(own));
        ASSERT_EQ(told["links"].size(), own.links.size());
        for (std::size_t k = 0; k < own.links.size(); ++k) {
            EXPECT_EQ(told["links"][k]["source"], own.links[k].source);
            EXPECT_EQ(told["links"][k]["verdict"], own.links[k].words);
            EXPECT_NEAR(told["links"][k]["brings"][0].get<double>(), own.links[k].mean[0], 1e-12);
        }
    }
    /// Clicks the floor near its middle.
    Json pick() {
        const Surface &floor = scene->surface(SurfaceId(0));
        const Vec2 p = centroid(floor.outline) + spot.cwiseProduct(Vec2::Constant(radius(floor.outline)));
        session.click(on_screen(scene->own.to_own(floor.frame.to_space(p))));
        return session.wait_until("the element", answered)["inspected"];
    }

    Session session;
    std::shared_ptr<const Scene> scene;
    Options options;
};

class PlanarElementTest : public ElementTest {
protected:
    PlanarElementTest() : ElementTest(BasisFamily::planar) {}
};

TEST_F(ElementTest, AClickTellsTheElementItsLinksAndItsHistory) {
    const Json told = pick();
    EXPECT_EQ(told["surface"], 0);
    EXPECT_FALSE(told.contains("xray"));
    expect_told(told, own_report(Strategy::discontinuity_wavelet, 6, told));
}

TEST_F(PlanarElementTest, AClickTellsTheElementItsLinksAndItsHistory) {
    const Json told = pick();
    expect_told(told, own_report(Strategy::discontinuity_wavelet, 6, told));
}

TEST_F(ElementTest, ARowDrawsAndXraysItsLinks) {
    const Json told = pick();
    ASSERT_FALSE(told["links"].empty());
    const std::string row = "link from " + told["links"][0]["source"].dump();
    session.move({300, 20});
    const Screenshot before = session.shot();
    session.click(row);
    const Json s = session.wait_until("the X-ray", [](const Json &now) { return answered(now) && now["inspected"].contains("xray"); });
    EXPECT_EQ(s["inspected"]["xray"]["points"], n_xray_points);
    EXPECT_EQ(s["inspected"]["xray"]["line"], "centre");
    session.settled();
    session.move({300, 20});
    EXPECT_GT(changed_share(before, session.shot(), session.widget("pane 0")), 0.001) << "links and line in the scene";
    session.click("xray.worst");
    session.wait_until("the other line", [](const Json &now) {
        return answered(now) && now["inspected"].contains("xray") && now["inspected"]["xray"]["line"] == "worst";
    });
    session.settled();
    const Box plot = session.widget("xray plot");
    session.move({plot.x + 0.6 * plot.width, plot.y + 0.5 * plot.height});
    const Json pointed = session.wait_until("a place", [](const Json &now) {
        return now["inspected"].contains("xray") && now["inspected"]["xray"]["cursor"].is_number();
    });
    const double part = pointed["inspected"]["xray"]["cursor"].get<double>() / pointed["inspected"]["xray"]["length"].get<double>();
    EXPECT_GT(part, 0.4);
    EXPECT_LT(part, 0.7);
    session.click(row);
    session.wait_until("no X-ray", [](const Json &now) { return answered(now) && !now["inspected"].contains("xray"); });
    // One thing at a time: a curve that the click may have pinned goes first.
    for (int n = 0; n < 2 && session.settled()["inspector"] != "none"; ++n)
        session.key("Escape");
    session.wait_until("closed", [](const Json &now) { return now["inspector"] == "none"; });
}

TEST_F(ElementTest, FollowsStepsBackAndStrategies) {
    pick();
    session.key("Left");
    Json told = session.wait_until("the step before", [](const Json &s) { return s["position"] == 3 && answered(s); })["inspected"];
    expect_told(told, own_report(Strategy::discontinuity_wavelet, 3, told));
    for (const auto &[key, strategy] : {std::pair("1", Strategy::uniform_constant), {"2", Strategy::discontinuity_constant},
                                        {"3", Strategy::uniform_wavelet}}) {
        session.key(key);
        told = session.wait_until("another strategy", [&](const Json &s) {
            return s["strategies"][0] == name(strategy) && s["panes"][0].value("computed", 0) >= 3 && !s["busy"] && answered(s);
        })["inspected"];
        expect_told(told, own_report(strategy, 3, told));
    }
}

TEST_F(ElementTest, TellsOfAPinnedCurve) {
    const auto snapshot = Solver(scene, options).snapshot();
    const auto curve = std::ranges::find_if(*snapshot->curves, [&](const SnapshotCurve &c) {
        return c.receiver == 0 && c.points.size() == 2 && (c.points[1] - c.points[0]).norm() > 0.3;
    });
    ASSERT_NE(curve, snapshot->curves->end());
    session.click(on_screen((curve->points[0] + curve->points[1]) / 2));
    session.wait_until("both", [](const Json &s) { return s["pinned_curve"].is_number() && answered(s); });
    session.key("Escape");
    session.wait_until("let go", [](const Json &s) { return s["pinned_curve"].is_null() && s["inspector"] == "element"; });
}

} // namespace
} // namespace penumbra::gui
