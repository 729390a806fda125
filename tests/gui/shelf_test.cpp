// The shelf of hard cases in the window: badges, progress, cancel, and the cases' scenes.
#include "gui/session.h"

#include "check_worker.h"
#include "sanitizers/time_factor.h"
#include "study/hard_cases.h"

#include <gtest/gtest.h>

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace penumbra::gui {
namespace {

int count(const Json &s, const std::string &status) {
    int n = 0;
    for (const auto &[name, verdicts] : s["shelf"]["cases"].items())
        for (const Json &v : verdicts)
            n += v == status;
    return n;
}

class ShelfTest : public testing::Test {
protected:
    explicit ShelfTest(std::vector<std::string> arguments = {}) : session(std::move(arguments)) {}
    void open() {
        session.key("h");
        session.wait_until("the shelf", [](const Json &s) {
            return s["inspector"] == "hard_cases" && s["widgets"].contains("case plain");
        });
        session.settled();
    }
    Session session;
};

TEST_F(ShelfTest, EveryCaseIsThereAndTheVerdictsAreExamines) {
    open();
    const auto cases = hard_cases();
    Json s = session.state();
    ASSERT_EQ(s["shelf"]["cases"].size(), cases.size());
    EXPECT_EQ(count(s, "not run"), 2 * static_cast<int>(cases.size()));
    session.click("check.all");
    s = session.wait_until(
        "all verdicts",
        [&](const Json &now) {
            return now["shelf"]["checking"] == false &&
                   count(now, "ok") + count(now, "failed") == 2 * static_cast<int>(cases.size());
        },
        300);
    for (const HardCase &hard_case : cases)
        for (const BasisFamily basis : {BasisFamily::parametric, BasisFamily::planar})
            EXPECT_EQ(s["shelf"]["cases"][hard_case.name][static_cast<std::size_t>(basis)],
                      examine(hard_case, basis).holds() ? "ok" : "failed")
                << hard_case.name << " " << name(basis);
    EXPECT_NE(s["message"].get<std::string>().find("hold"), std::string::npos) << s["message"];
    // The badge of one that holds is green on the screen.
    for (const char *badge : {"case edge-90-degrees parametric", "case edge-90-degrees planar"})
        EXPECT_GT(share_of(session.shot(), session.widget(badge), {0, 115, 84}, 6), 0.3) << badge;
}

TEST_F(ShelfTest, AClickOpensTheScene) {
    open();
    session.click("case one-corner");
    Json s = session.wait_until("the scene", [](const Json &now) {
        return now["scene"] == "one-corner" && !now["panes"].empty() && now["panes"][0].contains("version");
    });
    EXPECT_EQ(s["options"]["basis"], "parametric");
    EXPECT_NE(s["message"].get<std::string>().find("touches it at a corner"), std::string::npos) << s["message"];
    session.settled();
    // A badge opens it in its basis, and it can be solved.
    session.click("case plain planar");
    session.wait_until("another one, in the planar basis",
                       [](const Json &now) { return now["scene"] == "plain" && now["options"]["basis"] == "planar"; });
    session.settled();
    session.key("End");
    session.wait_until(
        "solved", [](const Json &now) { return now["panes"][0].value("converged", false); }, 60);
}

class BusyShelfTest : public ShelfTest {
protected:
    BusyShelfTest() : ShelfTest({"cornell-box", "--threshold", "0.0005", "--max-depth", "9"}) {}
};

TEST_F(BusyShelfTest, CheckingBesideALongSolveKeepsTheWindowAwakeAndStops) {
    open();
    session.key("End");
    session.wait_until("work", [](const Json &s) { return s["busy"] == true; });
    session.key("shift+h");
    session.wait_until("a verdict", [](const Json &s) {
        return s["shelf"]["checking"] == true && count(s, "ok") + count(s, "failed") > 0;
    });
    session.key("m");
    session.wait_until(
        "the mesh", [](const Json &s) { return s["layers"]["mesh"] == false; }, 5);
    session.click("check.stop");
    const Json s = session.wait_until(
        "the end", [](const Json &now) { return now["shelf"]["checking"] == false; }, 5);
    EXPECT_GT(count(s, "not run"), 0) << "it was done before it could be stopped";
    EXPECT_EQ(count(s, "running"), 0);
    EXPECT_EQ(s["busy"], true) << "the solver goes on";
    // Its sentences take the place of others. When it rests, the end of a check is said.
    session.key("Escape");
    session.wait_until("rest", [](const Json &now) { return now["busy"] == false; });
    session.key("shift+h");
    session.wait_until("a verdict", [](const Json &now) {
        return now["shelf"]["checking"] == true && count(now, "ok") + count(now, "failed") > 0;
    });
    session.click("check.stop");
    session.wait_until("word of it", [](const Json &now) {
        return now["shelf"]["checking"] == false && now["message"].get<std::string>().starts_with("Stopped: ");
    });
}

/// Reports of a worker, waited for.
struct Listener {
    std::mutex mutex;
    std::condition_variable told;
    int n = 0;
    void wake() {
        const std::scoped_lock lock(mutex);
        ++n;
        told.notify_all();
    }
    std::vector<CheckReport> collect(CheckWorker &worker, const std::function<bool(const CheckReport &)> &last) {
        std::vector<CheckReport> all;
        for (int seen = -1;;) {
            for (CheckReport &r : worker.take_reports()) {
                all.push_back(std::move(r));
                if (last(all.back()))
                    return all;
            }
            std::unique_lock lock(mutex);
            if (!told.wait_for(lock, std::chrono::duration<double>(10 * time_factor), [&] { return n != seen; }))
                return all;
            seen = n;
        }
    }
};

template <class Kind>
bool is(const CheckReport &r) {
    return std::holds_alternative<Kind>(r);
}

TEST(CheckWorker, ReportsEveryCaseInOrderAlsoOneThatThrows) {
    const auto measured = [](double value) {
        return [value](const TrialSetting &) { return std::vector<Measurement>{{"value", value, 1}}; };
    };
    Listener listener;
    CheckWorker worker([&] { listener.wake(); });
    worker.start({{"good", "", measured(0.5)},
                  {"throws", "", [](const TrialSetting &) -> std::vector<Measurement> { throw BadInput("no scene"); }},
                  {"bad", "", measured(2)}},
                 0);
    const auto reports = listener.collect(worker, is<CheckEnded>);
    ASSERT_EQ(reports.size(), 13u);
    for (std::size_t i = 0; i < 12; i += 2)
        EXPECT_TRUE(is<CaseBegun>(reports[i]));
    EXPECT_TRUE(std::get<CaseExamined>(reports[1]).result.holds());
    EXPECT_EQ(std::get<CaseExamined>(reports[3]).result.basis, BasisFamily::planar);
    EXPECT_EQ(std::get<CaseRefused>(reports[5]).sentence, "no scene");
    EXPECT_EQ(std::get<CaseRefused>(reports[7]).index, 1u);
    EXPECT_FALSE(std::get<CaseExamined>(reports[9]).result.holds());
    EXPECT_FALSE(std::get<CheckEnded>(reports[12]).stopped);
}

TEST(CheckWorker, StopsInTheMiddleOfACaseAndStartsAnew) {
    const HardCase endless{"endless", "", [](const TrialSetting &setting) -> std::vector<Measurement> {
                               for (;;) {
                                   setting.cancel->check();
                                   std::this_thread::sleep_for(std::chrono::milliseconds(1));
                               }
                           }};
    const HardCase quick{"quick", "", [](const TrialSetting &) { return std::vector<Measurement>{{"value", 0, 1}}; }};
    Listener listener;
    CheckWorker worker([&] { listener.wake(); });
    worker.start({endless, quick}, 0);
    listener.collect(worker, is<CaseBegun>);
    const auto start = std::chrono::steady_clock::now();
    worker.stop();
    const auto rest = listener.collect(worker, is<CheckEnded>);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    ASSERT_EQ(rest.size(), 1u);
    EXPECT_TRUE(std::get<CheckEnded>(rest[0]).stopped);
    EXPECT_LT(seconds, time_factor); // a busy machine may be slow to wake a thread
    // Anew, and over one that still goes on.
    worker.start({endless}, 0);
    listener.collect(worker, is<CaseBegun>);
    worker.start({quick}, 0);
    const auto again = listener.collect(worker, is<CheckEnded>);
    ASSERT_EQ(again.size(), 5u);
    EXPECT_FALSE(std::get<CheckEnded>(again.back()).stopped);
}

} // namespace
} // namespace penumbra::gui
