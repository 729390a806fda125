// The window answers while the worker computes, and stops it at once.
#include "gui/session.h"

#include "sanitizers/time_factor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <thread>
#include <vector>

namespace penumbra::gui {
namespace {

/// A scene and a threshold that keep the worker busy for long.
class BusyTest : public testing::Test {
protected:
    Session session{{"cornell-box", "--threshold", "0.0005", "--max-depth", "9"}};
    void begin() {
        session.key("End");
        session.wait_until("work", [](const Json &s) { return s["busy"] == true; });
        std::this_thread::sleep_for(std::chrono::milliseconds(700)); // well into a phase
        ASSERT_EQ(session.state()["busy"], true);
    }
};

TEST_F(BusyTest, EscCancelsWithinATenthOfASecond) {
    std::vector<double> times;
    for (int i = 0; i < 5; ++i) {
        begin();
        session.key("Escape");
        const Json stopped = session.wait_until("the answer", [](const Json &s) { return s["busy"] == false; }, 10);
        EXPECT_GE(stopped["cancel_ms"].get<double>(), 0);
        times.push_back(stopped["cancel_ms"].get<double>());
        // It stays stopped, at a complete state.
        std::this_thread::sleep_for(std::chrono::milliseconds(300));
        const Json later = session.state();
        EXPECT_EQ(later["busy"], false);
        EXPECT_EQ(later["position"], later["panes"][0]["computed"]);
    }
    std::ranges::sort(times); // the middle one: a busy machine may hold up one or the other
    EXPECT_LT(times[times.size() / 2], 100 * time_factor)
        << "shortest " << times.front() << ", longest " << times.back();
    // And goes on when asked to.
    const int position = session.state()["position"];
    session.key("shift+Right");
    session.wait_until("the next phase", [&](const Json &s) { return s["position"].get<int>() == position + 1; });
}

TEST_F(BusyTest, TheWindowAnswersMeanwhile) {
    begin();
    for (const bool mesh : {false, true, false}) {
        const auto start = std::chrono::steady_clock::now();
        session.key("m");
        session.wait_until("the mesh", [&](const Json &s) { return s["layers"]["mesh"] == mesh; });
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        EXPECT_LT(seconds, 3.0 * time_factor); // short of what the phases take here, however busy the machine is
    }
    EXPECT_EQ(session.state()["busy"], true);
}

TEST_F(BusyTest, BackNeedsNotWaitForThePhase) {
    session.key("shift+Right");
    session.wait_until("a phase", [](const Json &s) { return s["panes"][0]["computed"] == 1; }, 120);
    begin();
    session.key("Home");
    const Json state = session.wait_until("the start", [](const Json &s) { return s["position"] == 0; }, 2);
    session.wait_until("rest", [](const Json &s) { return s["busy"] == false; }, 2);
    EXPECT_EQ(session.state()["position"], 0);
}

TEST_F(BusyTest, AnotherSceneTakesOver) {
    begin();
    session.key("Escape");
    session.wait_until("rest", [](const Json &s) { return s["busy"] == false; }, 5);
    session.key("ctrl+o");
    session.wait_until("the dialog", [](const Json &s) { return s["open_dialog"] == true; });
    session.settled();
    session.type("figure-4");
    session.enter();
    session.wait_until("the scene", [](const Json &s) { return s["scene"] == "figure-4" && !s["busy"]; });
}

TEST(Idle, TheWindowSleepsWhenNothingHappens) {
    Session session;
    session.key("Right");
    session.settled();
    std::this_thread::sleep_for(std::chrono::seconds(4)); // the highlight of new patches has gone
    const double before = session.program().processor_seconds();
    std::this_thread::sleep_for(std::chrono::seconds(3));
    EXPECT_LT(session.program().processor_seconds() - before, 0.15);
}

} // namespace
} // namespace penumbra::gui
