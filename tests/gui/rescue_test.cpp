// When the window cannot go on: one line, a meaningful status, and what it showed is kept.
#include "gui/session.h"

#include "files/open_file.h"

#include <csignal>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace penumbra::gui {
namespace {

std::filesystem::path rescued(const Session &session) {
    return session.home() / ".local/state/penumbra/rescued.penumbra.json";
}

/// The line of that beginning in the log; the test fails where there is not just one from the program.
std::string line_of(const std::string &log) {
    const std::string start = "penumbra: ";
    const std::size_t at = log.find(start);
    EXPECT_NE(at, log.npos) << log;
    if (at == log.npos)
        return "";
    EXPECT_EQ(log.find("\n" + start, at), log.npos) << log;
    return log.substr(at, log.find('\n', at) - at);
}

/// `offered`: the next start asks whether to restore it, as nobody has wished for this end.
void expect_rescued(Session &session, int position, bool offered) {
    ASSERT_TRUE(std::filesystem::exists(rescued(session)));
    EXPECT_NE(line_of(session.log()).find("what it showed is kept: penumbra view " + rescued(session).string()),
              std::string::npos)
        << session.log();
    const OpenedFile opened = open_file(rescued(session).string());
    EXPECT_EQ(opened.scene->name, "slanted-edge");
    EXPECT_EQ(opened.state->position, position);
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(rescued(session).parent_path()), {}), offered ? 2 : 1)
        << "and no part";
    const auto autosave = "autosave-" + std::to_string(session.program().id()) + ".penumbra.json";
    EXPECT_EQ(std::filesystem::exists(rescued(session).parent_path() / autosave), offered);
}

const std::vector<std::string> scene{"slanted-edge", "--threshold", "0.05"};

void step(Session &session) {
    session.key("Right");
    session.wait_until("a step", [](const Json &s) { return s["position"] == 3 && !s["busy"]; });
}

TEST(Rescue, SignalsKeepWhatWasShown) {
    for (const int signal : {SIGINT, SIGTERM}) {
        Session session(scene);
        step(session);
        ASSERT_EQ(::kill(session.program().id(), signal), 0);
        EXPECT_EQ(session.program().wait(5), 128 + signal);
        EXPECT_NE(line_of(session.log()).find("interrupted; "), std::string::npos);
        expect_rescued(session, 3, false);
    }
}

/// The worker is in the middle of a phase: what is kept is the last complete one.
TEST(Rescue, ASignalWhileTheWorkerIsBusy) {
    Session session({"cornell-box", "--threshold", "0.0005", "--max-depth", "9"});
    session.key("End");
    session.wait_until(
        "work", [](const Json &s) { return s["busy"] == true && s["panes"][0]["computed"] > 0; }, 60);
    ASSERT_EQ(::kill(session.program().id(), SIGTERM), 0);
    EXPECT_EQ(session.program().wait(5), 143);
    const int position = open_file(rescued(session).string()).state->position;
    EXPECT_GE(position, 1);
    EXPECT_LT(position, 300) << "what was shown, not what was asked for";
}

TEST(Rescue, ALostContextIsStatusFive) {
    std::vector<std::string> arguments = scene;
    arguments.emplace_back("--lose-context");
    Session session(arguments);
    session.key("Right");
    EXPECT_EQ(session.program().wait(20), 5);
    EXPECT_NE(line_of(session.log()).find("the graphics driver has lost what the window draws with; "),
              std::string::npos);
    expect_rescued(session, 3, true);
}

TEST(Rescue, ADisplayThatGoesIsStatusFive) {
    Session session(scene);
    step(session);
    session.end_display();
    EXPECT_EQ(session.program().wait(20), 5);
    EXPECT_NE(line_of(session.log()).find("the display has gone; "), std::string::npos);
    expect_rescued(session, 3, true);
}

TEST(Rescue, WhereNothingCanBeKeptThatIsSaid) {
    Session session(scene);
    step(session);
    std::filesystem::create_directories(session.home() / ".local");
    std::filesystem::remove_all(session.home() / ".local/state");
    std::filesystem::create_symlink("/proc/none", session.home() / ".local/state");
    ASSERT_EQ(::kill(session.program().id(), SIGTERM), 0);
    EXPECT_EQ(session.program().wait(5), 143);
    EXPECT_NE(line_of(session.log()).find("what it showed could not be kept: cannot make the folder"),
              std::string::npos);
}

TEST(MemoryLimit, TheWindowStopsTheSolverAndGoesOn) {
    Session session({"cornell-box", "--threshold", "0.0005", "--max-depth", "9", "--memory-limit", "1"}); // met at once
    session.key("End");
    const Json stopped = session.wait_until(
        "the line", [](const Json &s) { return s["message_is_error"] == true; }, 10);
    EXPECT_EQ(stopped["message"], "The memory limit of 1 MiB stopped the solver; this is the last complete state.");
    session.wait_until("rest", [](const Json &s) { return s["busy"] == false; });
    EXPECT_EQ(session.state()["position"], session.state()["panes"][0]["computed"]);
    session.key("m");
    session.wait_until("the mesh", [](const Json &s) { return s["layers"]["mesh"] == false; });
}

} // namespace
} // namespace penumbra::gui
