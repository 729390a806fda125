// What accuracy costs, in the window: asked by tolerance, its price, and the plot of errors against work.
#include "gui/session.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace penumbra::gui {
namespace {

bool converged(const Json &s) { return !s["panes"].empty() && s["panes"][0].value("converged", false); }

Point along(const Box &slider, double share) {
    return {slider.x + share * slider.width, slider.y + 0.5 * slider.height};
}

void ask_by_tolerance(Session &session) {
    session.click("asked tolerance");
    session.wait_until("a tolerance", [](const Json &s) { return s["options"]["tolerance"] == 0.01; });
    session.settled();
}

void solve(Session &session) {
    session.key("End");
    session.wait_until("the end", converged, 60);
    session.settled();
}

TEST(Tolerance, IsAskedForReachedAndToldInWords) {
    Session session({"slanted-edge"});
    EXPECT_TRUE(session.state()["options"]["tolerance"].is_null());
    ask_by_tolerance(session);
    solve(session);
    const Json s = session.state();
    EXPECT_LE(s["panes"][0]["estimated_error"], 0.01);
    EXPECT_GE(s["panes"][0]["error_bound"], s["panes"][0]["estimated_error"]);
    EXPECT_NE(s["message"].get<std::string>().find("1 % asked for"), std::string::npos) << s["message"];
    // And back: the threshold is the one before, with the paper's depth limit.
    session.click("asked threshold");
    const Json back = session.wait_until("a threshold", [](const Json &now) { return now["options"]["tolerance"].is_null(); });
    EXPECT_EQ(back["options"]["max_depth"], 6);
    EXPECT_EQ(back["options"]["threshold"], s["options"]["threshold"]);
}

TEST(Tolerance, ComesBackWithASavedState) {
    Session session({"slanted-edge", "--tolerance", "0.05"});
    EXPECT_EQ(session.state()["options"]["tolerance"], 0.05);
    session.key("ctrl+s");
    const std::string file =
        session.wait_until("the state", [](const Json &s) { return s["saved"] != ""; })["saved"].get<std::string>();
    session.click("asked threshold");
    session.wait_until("a threshold", [](const Json &s) { return s["options"]["tolerance"].is_null(); });
    session.drop(file);
    session.wait_until("the tolerance", [](const Json &s) { return s["options"]["tolerance"] == 0.05; });
}

TEST(Tolerance, ItsPriceIsPredictedWhereSomethingWasMeasured) {
    Session session({"slanted-edge"});
    ask_by_tolerance(session);
    const Box slider = session.widget("tolerance");
    session.drag(along(slider, 0.5), along(slider, 0.45));
    session.wait_until("another tolerance", [](const Json &s) { return s["options"]["tolerance"] != 0.01; });
    EXPECT_TRUE(session.settled()["price"].is_null()) << "nothing was measured yet";
    solve(session);
    const Json measured = session.state();
    session.drag(along(slider, 0.45), along(slider, 0.25));
    const Json s = session.wait_until("a finer tolerance", [&](const Json &now) {
        return now["options"]["tolerance"] < measured["options"]["tolerance"] && !now["price"].is_null();
    });
    // More accurate: at least as many patches, and not a hundred times as many.
    EXPECT_GE(s["price"]["patches"], measured["panes"][0]["patches"]);
    EXPECT_LT(s["price"]["patches"].get<double>(), 100 * measured["panes"][0]["patches"].get<double>());
    EXPECT_GT(s["price"]["seconds"], 0);
    EXPECT_GT(s["price"]["bytes"], 0);
}

class CostTest : public testing::Test {
protected:
    CostTest() : session({"slanted-edge"}, 1400, 900) {
        session.key("a");
        session.wait_until("the panel", [](const Json &s) { return s["inspector"] == "cost"; });
        session.settled();
    }
    bool has(const std::string &widget) { return session.state()["widgets"].contains(widget); }
    Session session;
};

TEST_F(CostTest, EachStepAddsAPointAndAClickGoesBackToIt) {
    EXPECT_FALSE(has("cost point d 1"));
    for (const char *point : {"cost point d 1", "cost point d 2", "cost point d 3"}) {
        session.key("Right");
        session.wait_until(point, [&](const Json &s) { return s["widgets"].contains(point); });
        session.settled();
    }
    EXPECT_EQ(session.state()["position"], 9);
    // Later ones are more accurate, which is further down, and took longer, which is further right.
    const Point first = session.middle("cost point d 1"), last = session.middle("cost point d 3");
    EXPECT_LT(first.x, last.x);
    EXPECT_LT(first.y, last.y);
    session.click("cost point d 1");
    session.wait_until("the first step", [](const Json &s) { return s["position"] == 3; });
}

TEST_F(CostTest, TheMeasureMovesThePoints) {
    session.key("ctrl+4");
    session.key("End");
    session.wait_until(
        "four solutions",
        [](const Json &s) {
            for (const Json &p : s["panes"])
                if (!p.value("converged", false))
                    return false;
            return s["panes"].size() == 4;
        },
        120);
    session.settled();
    const Box plot = session.widget("cost plot");
    Screenshot before = session.shot();
    for (const char *measure : {"patches", "coefficients", "link_coefficients", "kernel_evaluations", "seconds"}) {
        session.click(std::string("cost ") + measure);
        session.wait_until(measure, [&](const Json &s) { return s["cost_measure"] == measure; });
        const Screenshot after = session.shot();
        EXPECT_GT(changed_share(before, after, plot), 0.01) << measure;
        before = after;
    }
    for (const char *bar : {"cost bar a", "cost bar b", "cost bar c", "cost bar d"})
        EXPECT_TRUE(has(bar)) << bar;
}

TEST_F(CostTest, RunsBeforeStayAndCanBeSolvedAgain) {
    session.key("Right");
    session.wait_until("a point", [](const Json &s) { return s["widgets"].contains("cost point d 1"); });
    session.settled();
    const Json before = session.state();
    const Box slider = session.widget("threshold");
    session.drag(along(slider, 0.7), along(slider, 0.4));
    session.wait_until("another run", [&](const Json &s) {
        return s["run"] != before["run"] && s["widgets"].contains("cost point d 1 earlier");
    });
    session.settled();
    session.key("Left");
    session.wait_until("the start", [](const Json &s) { return s["position"] == 0; });
    session.settled();
    session.click("cost point d 1 earlier");
    const Json after = session.wait_until("the options before", [&](const Json &s) {
        return s["options"]["threshold"] == before["options"]["threshold"] && s["position"] == 3;
    });
    EXPECT_NE(after["run"], before["run"]);
}

} // namespace
} // namespace penumbra::gui
