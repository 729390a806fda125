// Curves under the mouse, their filters, and the keyhole.
#include "gui/session.h"

#include "iteration/solver.h"
#include "render/camera.h"
#include "scene/bundled.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

namespace penumbra::gui {
namespace {

/// The same curves as the window's, from a solver of our own, and where they must be on its screen.
class CurvesTest : public testing::Test {
protected:
    CurvesTest()
        : session({"skew-blockers"}),
          snapshot(Solver(std::make_shared<const Scene>(open_scene("skew-blockers")), Options{}).snapshot()),
          pane(session.widget("pane 0")) {}

    Point on_screen(const Vec3 &p) const {
        const Json camera = session.state()["camera"];
        const auto vector = [](const Json &v) {
            return glm::dvec3(v[0].get<double>(), v[1].get<double>(), v[2].get<double>());
        };
        const Camera c{vector(camera["eye"]), vector(camera["target"]), vector(camera["up"]),
                       camera["fov"].get<double>()};
        const auto at = place_in_frame(c, static_cast<double>(pane.width) / pane.height, {p.x(), p.y(), p.z()});
        return {pane.x + (0.5 + 0.5 * at->x) * pane.width, pane.y + (0.5 - 0.5 * at->y) * pane.height};
    }
    static Vec3 middle(const SnapshotCurve &curve) { return (curve.points[0] + curve.points[1]) / 2; }
    static double distance(const SnapshotCurve &curve, const Vec3 &p) {
        double least = 1e300;
        for (std::size_t k = 0; k + 1 < curve.points.size(); ++k) {
            const Vec3 d = curve.points[k + 1] - curve.points[k];
            const double t = std::clamp((p - curve.points[k]).dot(d) / d.squaredNorm(), 0.0, 1.0);
            least = std::min(least, (curve.points[k] + t * d - p).norm());
        }
        return least;
    }
    /// Distance of the nearest other curve from the curve's middle.
    double room(std::size_t i) const {
        double least = 1e300;
        for (std::size_t j = 0; j < snapshot->curves->size(); ++j)
            if (j != i)
                least = std::min(least, distance((*snapshot->curves)[j], middle((*snapshot->curves)[i])));
        return least;
    }
    /// The straight curve of the kind whose middle has the most room about it.
    int lonely(int kind) const {
        int best = -1;
        for (std::size_t i = 0; i < snapshot->curves->size(); ++i)
            if ((*snapshot->curves)[i].kind == kind && (*snapshot->curves)[i].points.size() == 2 &&
                (best < 0 || room(i) > room(static_cast<std::size_t>(best))))
                best = static_cast<int>(i);
        return best;
    }
    void move_away() {
        session.move({pane.x + 5.0, pane.y + 300.0});
        session.wait_until("nothing under the mouse",
                           [](const Json &s) { return s["hovered_curve"].is_null() && s["under_cursor"].is_null(); });
    }
    void rest_on(int curve) {
        session.move(on_screen(middle((*snapshot->curves)[static_cast<std::size_t>(curve)])));
        session.wait_until("the curve", [&](const Json &s) { return s["hovered_curve"] == curve; });
    }

    Session session;
    std::shared_ptr<const Snapshot> snapshot;
    Box pane;
};

TEST_F(CurvesTest, TheMouseFindsACurveAndShowsItsSurface) {
    const int curve = lonely(0);
    ASSERT_GE(curve, 0);
    move_away();
    const Screenshot before = session.shot();
    rest_on(curve);
    // Between light and floor, far from the tooltip: the wedge's sheet.
    const Box above{pane.x + pane.width / 4, pane.y + 110, pane.width / 2, 130};
    EXPECT_GT(changed_share(before, session.shot(), above), 0.003);
    move_away();
    EXPECT_EQ(changed_share(before, session.shot(), above), 0);
}

TEST_F(CurvesTest, AClickPinsItUntilAClickElsewhereOrEscape) {
    const int curve = lonely(0);
    const Point at = on_screen(middle((*snapshot->curves)[static_cast<std::size_t>(curve)]));
    const auto pinned = [&](const Json &s) { return s["pinned_curve"] == curve && s["curves"]["shown"] == curve; };
    const auto free = [](const Json &s) { return s["pinned_curve"].is_null(); };
    session.click(at);
    session.wait_until("pinned", pinned);
    move_away();
    session.settled();
    EXPECT_TRUE(pinned(session.state()));
    session.click(Point{pane.x + 5.0, pane.y + 300.0});
    session.wait_until("let go by a click", free);
    session.click(at);
    session.wait_until("pinned again", pinned);
    session.key("Escape");
    session.wait_until("let go by Escape", free);
    // A drag is no click.
    session.drag(at, {at.x + 60, at.y});
    session.settled();
    EXPECT_TRUE(free(session.state()));
}

TEST_F(CurvesTest, FiltersHideCurvesFromTheEyeAndFromTheMouse) {
    const int curve = lonely(0);
    rest_on(curve);
    move_away();
    const Screenshot all = session.shot();
    session.click("kind VE");
    session.wait_until("no VE", [](const Json &s) {
        return s["curves"]["kinds"] == Json::array({"EV", "EEE", "plane", "contact"});
    });
    session.move(on_screen(middle((*snapshot->curves)[static_cast<std::size_t>(curve)])));
    session.settled();
    EXPECT_TRUE(session.state()["hovered_curve"].is_null());
    move_away();
    const double some = changed_share(all, session.shot(), pane);
    EXPECT_GT(some, 0.001);
    session.click("curve order 2");
    session.wait_until("no second order", [](const Json &s) { return s["curves"]["orders"] == Json::array({0, 1}); });
    move_away();
    EXPECT_GT(changed_share(all, session.shot(), pane), some);
    session.click("curve order 2");
    session.click("kind VE");
    session.wait_until(
        "all", [](const Json &s) { return s["curves"]["orders"].size() == 3 && s["curves"]["kinds"].size() == 5; });
    move_away();
    EXPECT_EQ(changed_share(all, session.shot(), pane), 0);
}

TEST_F(CurvesTest, TheKeyholeFollowsTheDragAndTellsOfCrossings) {
    const int curve = lonely(0);
    const SnapshotCurve &c = (*snapshot->curves)[static_cast<std::size_t>(curve)];
    const double reach = std::min(0.12, 0.6 * room(static_cast<std::size_t>(curve)));
    const Vec3 across = reach * Vec3::UnitZ().cross(c.points[1] - c.points[0]).normalized();
    session.click("view.keyhole");
    session.wait_until("the keyhole",
                       [](const Json &s) { return s["looking"]["open"] == true && s["widgets"].contains("keyhole"); });
    const Json before = session.state();
    EXPECT_TRUE(before["keyhole"].is_array());
    session.drag(on_screen(middle(c) - across), on_screen(middle(c) + across));
    const Json after =
        session.wait_until("a crossing", [&](const Json &s) { return s["looking"]["crossed"] == curve; });
    EXPECT_EQ(after["camera"], before["camera"]) << "the drag moves the point, not the eye";
    EXPECT_EQ(after["looking"]["surface"], 0);
    const Vec3 wanted = middle(c) + across;
    EXPECT_NEAR(after["keyhole"][0].get<double>(), wanted.x(), 0.02);
    EXPECT_NEAR(after["keyhole"][1].get<double>(), wanted.y(), 0.02);
    EXPECT_EQ(after["looking"]["emitters"].size(), 1u);
    EXPECT_NE(after["looking"]["news"].get<std::string>().find("A corner of "), std::string::npos)
        << after["looking"]["news"];
    // The inset shows something bright on something dark.
    const Box inset = session.widget("keyhole");
    EXPECT_GT(share_of(session.shot(), inset, {255, 243, 208}, 4), 0.02);
    session.key("Escape");
    session.wait_until("closed", [](const Json &s) { return s["looking"]["open"] == false && s["keyhole"].is_null(); });
}

} // namespace
} // namespace penumbra::gui
