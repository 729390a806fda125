// The mouse in a pane: orbit, pan, zoom about the point under it, pivot.
#include "gui/session.h"

#include "render/camera.h"

#include <gtest/gtest.h>

#include <glm/glm.hpp>

#include <cmath>

namespace penumbra::gui {
namespace {

glm::dvec3 vector(const Json &j) { return {j[0].get<double>(), j[1].get<double>(), j[2].get<double>()}; }

Camera camera(const Json &state) {
    const Json &c = state["camera"];
    return {vector(c["eye"]), vector(c["target"]), vector(c["up"]), c["fov"].get<double>()};
}

double aspect(const Box &b) { return static_cast<double>(b.width) / b.height; }

/// Where the point of space stands in the pane [-1, 1].
glm::dvec2 seen_at(const Camera &c, const Box &pane, const glm::dvec3 &x) {
    const glm::dvec4 v = view_matrix(c) * glm::dvec4(x, 1);
    const double t = std::tan(glm::radians(0.5 * c.fov_y));
    return {v.x / (-v.z * t * aspect(pane)), v.y / (-v.z * t)};
}

glm::dvec2 frame(const Box &pane, Point p) {
    return {2 * (std::round(p.x) - pane.x) / pane.width - 1, 1 - 2 * (std::round(p.y) - pane.y) / pane.height};
}

/// Point of the floor z = 0 under the mouse.
glm::dvec3 floor_under(const Camera &c, const Box &pane, Point p) {
    const glm::dvec2 f = frame(pane, p);
    const glm::dvec3 ray = view_ray(c, aspect(pane), f.x, f.y);
    return c.eye - ray * (c.eye.z / ray.z);
}

class CameraTest : public testing::Test {
protected:
    Session session;
    Box pane = session.widget("pane 0");
    /// On the floor in front, left of the blocker.
    Point on_floor{pane.x + 0.4 * pane.width, pane.y + 0.72 * pane.height};
    Camera before = camera(session.state());

    Camera after_change(const std::string &what) {
        return camera(session.wait_until(what, [&](const Json &s) { return camera(s).eye != before.eye; }));
    }
};

TEST_F(CameraTest, LeftDragTurnsAboutThePointUnderTheMouse) {
    const glm::dvec3 pivot = floor_under(before, pane, on_floor);
    session.drag(on_floor, {on_floor.x + 90, on_floor.y - 30});
    after_change("an orbit");
    const Camera after = camera(session.settled());
    EXPECT_NEAR(glm::distance(after.eye, pivot), glm::distance(before.eye, pivot), 1e-6);
    EXPECT_GT(glm::distance(after.eye, before.eye), 0.1);
    const glm::dvec2 p = frame(pane, on_floor), q = seen_at(after, pane, pivot);
    EXPECT_NEAR(p.x, q.x, 1e-3); // a pivot stays where it is in the picture
    EXPECT_NEAR(p.y, q.y, 1e-3);
}

TEST_F(CameraTest, RightMiddleAndShiftLeftDragsMoveAlong) {
    const Point to{on_floor.x + 80, on_floor.y + 20};
    for (const auto &[button, modifier] : {std::pair<int, std::string>{3, ""}, {2, ""}, {1, "shift"}}) {
        SCOPED_TRACE(std::to_string(button) + modifier);
        session.key("r");
        session.settled();
        const glm::dvec3 held = floor_under(before, pane, on_floor);
        session.drag(on_floor, to, button, modifier);
        after_change("a pan");
        const Camera after = camera(session.settled());
        const glm::dvec3 moved = after.eye - before.eye;
        EXPECT_LT(glm::distance(moved, after.target - before.target), 1e-9); // no turning
        const glm::dvec2 p = frame(pane, to), q = seen_at(after, pane, held);
        EXPECT_NEAR(p.x, q.x, 0.01); // what was taken hold of follows the mouse
        EXPECT_NEAR(p.y, q.y, 0.01);
    }
}

TEST_F(CameraTest, WheelUpComesNearerToThePointUnderTheMouse) {
    const glm::dvec3 point = floor_under(before, pane, on_floor);
    session.click(on_floor, 4);
    Camera after = after_change("a zoom in");
    EXPECT_LT(glm::distance(after.eye, point), 0.95 * glm::distance(before.eye, point));
    EXPECT_LT(glm::distance(seen_at(after, pane, point), frame(pane, on_floor)), 1e-3);
    session.click(on_floor, 5);
    session.wait_until("a zoom out", [&](const Json &s) { return glm::distance(camera(s).eye, before.eye) < 1e-6; });
}

TEST_F(CameraTest, DoubleClickSetsThePivot) {
    EXPECT_TRUE(session.state()["pivot"].is_null());
    const glm::dvec3 point = floor_under(before, pane, on_floor);
    session.click(on_floor, 1, 2);
    const Json with = session.wait_until("a pivot", [](const Json &s) { return !s["pivot"].is_null(); });
    EXPECT_LT(glm::distance(vector(with["pivot"]), point), 1e-6);
    EXPECT_EQ(camera(with).eye, before.eye); // the view does not jump

    const Point elsewhere{pane.x + 0.7 * pane.width, pane.y + 0.5 * pane.height};
    session.drag(elsewhere, {elsewhere.x - 70, elsewhere.y});
    after_change("an orbit");
    const Camera after = camera(session.settled());
    EXPECT_NEAR(glm::distance(after.eye, point), glm::distance(before.eye, point), 1e-6);

    session.key("r");
    const Json reset = session.wait_until("the first view", [&](const Json &s) { return camera(s).eye == before.eye; });
    EXPECT_TRUE(reset["pivot"].is_null());
}

TEST_F(CameraTest, PanesShareTheEye) {
    session.key("ctrl+2");
    session.wait_until("two panes", [](const Json &s) { return s["panes"].size() == 2; });
    const Screenshot shot = session.shot();
    const Box left = session.widget("pane 0"), right = session.widget("pane 1");
    session.drag(session.middle("pane 1"), {session.middle("pane 1").x + 120, session.middle("pane 1").y});
    after_change("an orbit in the right pane");
    const Screenshot turned = session.shot();
    EXPECT_GT(changed_share(shot, turned, left), 0.02);
    EXPECT_GT(changed_share(shot, turned, right), 0.02);
}

TEST_F(CameraTest, TheViewOutlivesSteps) {
    session.drag(on_floor, {on_floor.x + 50, on_floor.y});
    after_change("an orbit");
    const Camera turned = camera(session.settled());
    session.key("Right");
    const Json stepped = session.wait_until("a step", [](const Json &s) { return s["panes"][0]["iteration"] == 1; });
    EXPECT_EQ(camera(stepped).eye, turned.eye);
}

} // namespace
} // namespace penumbra::gui
