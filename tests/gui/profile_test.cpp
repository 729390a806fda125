// The profile in the window: a line that is dragged, its plot, and the place that is pointed at.
#include "gui/session.h"

#include "render/camera.h"

#include <gtest/gtest.h>

#include <cmath>

namespace penumbra::gui {
namespace {

class ProfileTest : public testing::Test {
protected:
    ProfileTest() : session({"slanted-edge"}) {
        session.key("Right");
        session.wait_until("a step", [](const Json &s) { return s["panes"][0].value("computed", 0) >= 3; });
        session.key("s");
        session.wait_until("the truth", known);
    }
    static bool known(const Json &s) {
        return s["profiling"]["open"] == true && s["profiling"].value("exact_points", 0) > 500 && !s["busy"];
    }
    Point on_screen(const glm::dvec3 &p) const {
        const Json camera = session.state()["camera"];
        const auto vector = [](const Json &v) {
            return glm::dvec3(v[0].get<double>(), v[1].get<double>(), v[2].get<double>());
        };
        const Camera c{vector(camera["eye"]), vector(camera["target"]), vector(camera["up"]),
                       camera["fov"].get<double>()};
        const Box pane = session.widget("pane 0");
        const auto at = place_in_frame(c, static_cast<double>(pane.width) / pane.height, p);
        return {pane.x + (0.5 + 0.5 * at->x) * pane.width, pane.y + (0.5 - 0.5 * at->y) * pane.height};
    }
    static glm::dvec3 end(const Json &s, int which) {
        const Json &p = s["profile"][static_cast<std::size_t>(which)];
        return {p[0].get<double>(), p[1].get<double>(), p[2].get<double>()};
    }

    Session session;
};

TEST_F(ProfileTest, OpensWithALineAcrossTheFloorAndClosesAgain) {
    const Json s = session.settled();
    EXPECT_GT(s["profiling"]["length"].get<double>(), 0);
    EXPECT_GE(s["profiling"]["pieces"][0].get<int>(), 1);
    EXPECT_GT(s["profiling"]["crossings"].get<int>(), 0);
    session.key("Escape");
    session.wait_until("closed",
                       [](const Json &now) { return now["profiling"]["open"] == false && now["profile"].is_null(); });
}

TEST_F(ProfileTest, ADragDrawsALineAndAnEndCanBeMoved) {
    const Json before = session.settled();
    const glm::dvec3 a = end(before, 0), b = end(before, 1), across(a.y - b.y, b.x - a.x, 0);
    const glm::dvec3 from = 0.7 * a + 0.3 * b + 0.1 * across, to = 0.3 * a + 0.7 * b + 0.2 * across;
    session.drag(on_screen(from), on_screen(to));
    const Json drawn = session.wait_until("the line", [&](const Json &s) {
        return known(s) && s["profile"] != before["profile"] && s["profiling"]["dragging"] == false;
    });
    EXPECT_EQ(drawn["camera"], before["camera"]) << "the drag draws, the eye stays";
    EXPECT_LT(glm::length(end(drawn, 0) - from), 0.03 * glm::length(b - a));
    EXPECT_LT(glm::length(end(drawn, 1) - to), 0.03 * glm::length(b - a));
    // Its end B, alone.
    const glm::dvec3 elsewhere = 0.5 * (a + b) - 0.15 * across;
    session.drag(on_screen(end(drawn, 1)), on_screen(elsewhere));
    const Json moved =
        session.wait_until("the end", [&](const Json &s) { return known(s) && s["profile"] != drawn["profile"]; });
    EXPECT_EQ(moved["profile"][0], drawn["profile"][0]);
    EXPECT_LT(glm::length(end(moved, 1) - elsewhere), 0.03 * glm::length(b - a));
}

TEST_F(ProfileTest, ThePlaceInThePlotIsMarkedInTheSceneAndTheOtherWayRound) {
    const Json s = session.settled();
    const Screenshot before = session.shot();
    const Box plot = session.widget("profile plot"), pane = session.widget("pane 0");
    session.move({plot.x + 0.5 * plot.width, plot.y + 0.4 * plot.height});
    const Json pointed =
        session.wait_until("a place", [](const Json &now) { return now["profiling"]["cursor"].is_number(); });
    const double part = pointed["profiling"]["cursor"].get<double>() / s["profiling"]["length"].get<double>();
    EXPECT_GT(part, 0.35);
    EXPECT_LT(part, 0.65);
    const Point there = on_screen(end(s, 0) + part * (end(s, 1) - end(s, 0)));
    const Box ring{static_cast<int>(there.x) - 10, static_cast<int>(there.y) - 10, 20, 20};
    EXPECT_GT(share_of(session.shot(), ring, {255, 200, 60}, 20), 0.05);
    EXPECT_GT(changed_share(before, session.shot(), plot), 0.005) << "rule and figures";
    EXPECT_GT(pane.height, 100);
    session.move(on_screen(0.25 * end(s, 1) + 0.75 * end(s, 0)));
    const Json in_scene = session.wait_until("the place in the scene", [&](const Json &now) {
        return now["profiling"]["cursor"].is_number() && now["profiling"]["cursor"] != pointed["profiling"]["cursor"];
    });
    EXPECT_NEAR(in_scene["profiling"]["cursor"].get<double>() / s["profiling"]["length"].get<double>(), 0.25, 0.02);
}

TEST_F(ProfileTest, FollowsThePanes) {
    session.key("ctrl+4");
    const Json s = session.wait_until("four solutions", [](const Json &now) {
        return now["profiling"].value("pieces", Json::array()).size() == 4 && !now["busy"];
    });
    for (const Json &pieces : s["profiling"]["pieces"])
        EXPECT_GE(pieces.get<int>(), 1);
    const Json before = s["profiling"]["pieces"];
    session.key("Right");
    session.key("Right");
    session.wait_until(
        "finer", [&](const Json &now) { return now["profiling"]["pieces"] != before; }, 60);
}

} // namespace
} // namespace penumbra::gui
