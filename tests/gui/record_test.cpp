// What is done in the window, written down and done again in a new one.
#include "gui/session.h"

#include "action.h"
#include "script_lines.h"
#include "verbs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <set>
#include <thread>
#include <unistd.h>

namespace penumbra::gui {
namespace {

std::string text_of(const std::filesystem::path &file) {
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), {}};
}

class RecordTest : public testing::Test {
protected:
    const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / ("record-" + std::to_string(::getpid()) + ".txt");

    void SetUp() override { std::filesystem::remove(file); }
    void TearDown() override { std::filesystem::remove(file); }

    /// What a new window comes to that plays it.
    Json played() const {
        int last = 0;
        const std::string text = text_of(file);
        last = static_cast<int>(std::ranges::count(text, '\n'));
        Session session({"--pace", "0", "--script", file.string()});
        session.wait_until("the end of\n" + text,
                           [&](const Json &s) { return s["script"]["line"] == last && s["script"]["playing"] == false; }, 120);
        return session.settled();
    }
};

/// Of the window that was at it, not of what it shows: where the mouse is, what was said and when, how often, how fast.
const std::set<std::string> of_the_session = {"under_cursor", "hovered_curve", "told",  "message", "inputs",  "changes", "script",
                                              "cancel_ms",    "run",           "price", "earlier_runs", "recent", "widgets", "hint"};

/// What differs, by its path in the JSON.
std::vector<std::string> differences(Json a, Json b) {
    for (Json *state : {&a, &b}) {
        for (const std::string &key : of_the_session)
            state->erase(key);
        for (Json &pane : (*state)["panes"])
            pane.erase("version"); // counts all that was solved
    }
    std::vector<std::string> paths;
    for (const Json &change : Json::diff(a, b))
        paths.push_back(change["path"].get<std::string>() + ": " +
                        (a.contains(Json::json_pointer(change["path"].get<std::string>()))
                             ? a[Json::json_pointer(change["path"].get<std::string>())].dump()
                             : "nothing") +
                        " is played as " + (change.contains("value") ? change["value"].dump() : "nothing"));
    return paths;
}

std::string joined(const std::vector<std::string> &lines) {
    std::string all;
    for (const std::string &line : lines)
        all += line + "\n";
    return all;
}

TEST_F(RecordTest, ALectureIsPlayedAgainToTheSameState) {
    Json recorded;
    {
        Session session({"--record", file.string()});
        const Json first = session.settled();
        session.key("Right");
        session.wait_until("a step", [](const Json &s) { return s["position"] == 3 && !s["busy"]; });
        session.key("ctrl+2"); // two panes
        session.key("3");      // the other strategy in the active one
        session.wait_until("its solution", [](const Json &s) { return s["panes"].size() == 2 && s["panes"][1]["computed"] >= 3 && !s["busy"]; });
        session.settled();
        session.click("order 2");
        session.wait_until("order 2", [](const Json &s) { return s["options"]["order"] == 2 && !s["busy"]; });
        session.settled();
        session.key("End");
        session.wait_until("the end", [](const Json &s) { return s["converged"] == true && !s["busy"]; }, 60);
        const Box pane = session.widget("pane 0");
        const Point floor{pane.x + 0.4 * pane.width, pane.y + 0.72 * pane.height};
        session.drag(floor, {floor.x + 70, floor.y - 25});
        session.wait_until("an orbit", [&](const Json &s) { return s["camera"]["eye"] != first["camera"]["eye"]; });
        session.settled();
        session.click("layers.mesh");
        session.wait_until("no mesh", [](const Json &s) { return s["layers"]["mesh"] == false; });
        session.key("c");
        session.key("shift+e");
        session.settled();
        session.key("v");
        session.wait_until("the keyhole", [](const Json &s) { return s["looking"]["open"] == true; });
        session.drag(floor, {floor.x + 60, floor.y + 10});
        session.settled();
        const Json all_curves = session.settled()["curves"];
        session.click("curve order 1");
        session.wait_until("fewer curves", [&](const Json &s) { return s["curves"] != all_curves; });
        session.settled();
        session.key("Left");
        session.settled();
        session.key("ctrl+z"); // of the filter
        session.wait_until("all curves", [&](const Json &s) { return s["curves"] == all_curves; });
        session.key("shift+b");
        session.key("shift+g");
        recorded = session.settled();
    }
    EXPECT_EQ(recorded["layers"]["mesh"], false);
    EXPECT_EQ(recorded["strategies"][1], "uniform-wavelet");
    EXPECT_FALSE(recorded["keyhole"].is_null());
    const Json again = played();
    EXPECT_EQ(joined(differences(recorded, again)), "") << text_of(file);
    EXPECT_EQ(joined(differences(again, recorded)), "") << text_of(file);
}

TEST_F(RecordTest, AWayThroughLinksIsPlayedAgain) {
    Json recorded;
    {
        Session session({"cornell-box", "--threshold", "0.03", "--record", file.string()});
        session.settled();
        session.key("Right");
        session.wait_until("a step", [](const Json &s) { return s["position"] == 3 && !s["busy"]; });
        session.key("ctrl+Down");
        session.wait_until("a link", [](const Json &s) { return s["position"] == 4 && s["linking"] == 1 && !s["busy"]; });
        session.settled();
        session.click("linkings"); // the middle of the bar: by its effect
        recorded = session.wait_until("some links", [](const Json &s) { return s["linking"] > 3 && !s["busy"]; });
        recorded = session.settled();
    }
    const Json again = played();
    EXPECT_EQ(joined(differences(recorded, again)), "") << text_of(file);
    EXPECT_NE(text_of(file).find("go 2 refine links " + recorded["linking"].dump() + "\n"), std::string::npos) << text_of(file);
}

TEST_F(RecordTest, PanesInOnePlaceAndViewsOfTheirOwnArePlayedAgain) {
    Json recorded;
    {
        Session session({"--record", file.string()});
        session.settled();
        session.key("Right");
        session.wait_until("a step", [](const Json &s) { return s["position"] == 3 && !s["busy"]; });
        session.key("ctrl+2");
        session.wait_until("two", [](const Json &s) { return s["layout"] == "two" && s["panes"][0]["computed"] >= 3 && !s["busy"]; });
        session.key("shift+l");
        session.settled();
        const Box second = session.widget("pane 1");
        const Point floor{second.x + 0.4 * second.width, second.y + 0.7 * second.height};
        session.drag(floor, {floor.x + 60, floor.y - 20});
        const Json moved = session.settled();
        ASSERT_EQ(moved["cameras"].size(), 2u);
        EXPECT_NE(moved["cameras"][0], moved["cameras"][1]);
        session.key("w");
        session.wait_until("the wipe", [](const Json &s) { return s["layout"] == "wipe"; });
        session.settled();
        const Box handle = session.widget("divider");
        const Point divider{handle.x + 0.5 * handle.width, handle.y + 0.5 * handle.height};
        session.drag(divider, {divider.x - 200, divider.y});
        EXPECT_LT(session.settled()["wipe"], 0.4);
        session.key("ctrl+2");
        recorded = session.settled();
    }
    EXPECT_EQ(recorded["layout"], "two");
    const Json again = played();
    EXPECT_EQ(joined(differences(recorded, again)), "") << text_of(file);
    EXPECT_NE(text_of(file).find("wipe 0."), std::string::npos) << text_of(file);
}

TEST_F(RecordTest, StepsAndExposuresOfTheirOwnArePlayedAgain) {
    Json recorded;
    {
        Session session({"--record", file.string()});
        session.settled();
        for (const char *key : {"ctrl+2", "shift+s", "Right", "shift+Tab", "shift+Right", "shift+k", "e", "shift+Tab", "shift+e", "k",
                                "shift+k", "ctrl+z", "shift+Tab", "Right"}) {
            session.key(key);
            session.settled();
        }
        recorded = session.settled();
    }
    EXPECT_EQ(recorded["positions"], Json({3, 3}));
    ASSERT_EQ(recorded["tones"].size(), 2u) << recorded["tones"];
    EXPECT_EQ(recorded["tones"][0]["exposure"], 0.5);
    EXPECT_EQ(recorded["tones"][1]["exposure"], -0.5);
    const Json again = played();
    EXPECT_EQ(joined(differences(recorded, again)), "") << text_of(file);
}

TEST_F(RecordTest, WhatIsPickedAndMovedIsPlayedAgain) {
    Json recorded;
    {
        Session session({"box-on-floor", "--threshold", "0.05", "--record", file.string()});
        session.settled();
        session.key("Right");
        session.wait_until("a step", [](const Json &s) { return s["position"] == 3 && !s["busy"]; });
        session.key("i");
        session.wait_until("the inspector", [](const Json &s) { return s["inspector"] == "element"; });
        session.settled();
        const Box pane = session.widget("pane 0");
        session.click(Point{pane.x + 0.5 * pane.width, pane.y + 0.8 * pane.height});
        const Json picked = session.wait_until("an element", [](const Json &s) { return s["inspected"].contains("links") && !s["busy"]; });
        ASSERT_FALSE(picked["inspected"]["links"].empty());
        session.settled();
        session.take_first_object();
        session.wait_until("one in hand", [](const Json &s) { return !s["object"].is_null(); });
        session.settled();
        const Box size = session.widget("object size");
        session.drag({size.x + 0.3 * size.width, size.y + 0.5 * size.height}, {size.x + 0.3 * size.width + 30, size.y + 0.5 * size.height});
        session.wait_until("another size", [](const Json &s) { return !s["moves"].empty() && !s["busy"]; });
        session.settled();
        session.key("ctrl+b");
        session.wait_until("a bookmark", [](const Json &s) { return s["bookmarks"].size() == 1; });
        session.key("x"); // errors
        session.wait_until("them", [](const Json &s) { return !s["busy"] && !s["panes"][0]["error"].is_null(); }, 120);
        session.key("k");
        recorded = session.settled();
    }
    EXPECT_FALSE(recorded["moves"].empty());
    const Json again = played();
    EXPECT_EQ(joined(differences(recorded, again)), "") << text_of(file);
}

TEST_F(RecordTest, ASolutionThatWasStoppedIsPlayedAsFarAsItCame) {
    Json recorded;
    {
        Session session({"cornell-box", "--tolerance", "0.003", "--record", file.string()});
        session.settled();
        session.key("End");
        session.wait_until("a few steps", [](const Json &s) { return s["panes"][0]["computed"] >= 4; }, 60);
        session.key("Escape");
        session.wait_until("a stop", [](const Json &s) { return s["cancel_ms"] >= 0; });
        recorded = session.settled();
    }
    ASSERT_EQ(recorded["converged"], false);
    EXPECT_EQ(text_of(file).find("solve.end"), std::string::npos) << text_of(file);
    const Json again = played();
    EXPECT_EQ(again["position"], recorded["position"]) << text_of(file);
    EXPECT_EQ(again["panes"][0]["patches"], recorded["panes"][0]["patches"]);
}

TEST_F(RecordTest, WhatWasPlayedIsPlayed) {
    Json recorded;
    {
        Session session({"--record", file.string()});
        session.settled();
        session.key("space");
        session.wait_until("the first splits", [](const Json &s) { return s["position"] == 4; });
        session.key("space");
        recorded = session.settled();
    }
    EXPECT_NE(text_of(file).find("\nplay "), std::string::npos) << text_of(file);
    EXPECT_EQ(joined(differences(recorded, played())), "") << text_of(file);
}

/// The comparison is no use where it cannot fail: one line less, and it has to.
TEST_F(RecordTest, ALineThatIsMissingIsFound) {
    Json recorded;
    {
        Session session({"--record", file.string()});
        session.settled();
        session.key("m");
        session.wait_until("no mesh", [](const Json &s) { return s["layers"]["mesh"] == false; });
        session.key("Right");
        session.wait_until("a step", [](const Json &s) { return s["position"] == 3 && !s["busy"]; });
        recorded = session.settled();
    }
    EXPECT_EQ(joined(differences(recorded, played())), "") << text_of(file);
    std::string text = text_of(file);
    const std::size_t at = text.find("layers.mesh\n");
    ASSERT_NE(at, std::string::npos) << text;
    std::ofstream(file) << text.erase(at, std::string("layers.mesh\n").size());
    EXPECT_EQ(joined(differences(recorded, played())), "/layers/mesh: false is played as true\n");
}

TEST_F(RecordTest, PausesAreWrittenDownAndTheFileIsWholeAllTheTime) {
    Session session({"--record", file.string()});
    session.settled();
    session.key("m");
    session.wait_until("no mesh", [](const Json &s) { return s["layers"]["mesh"] == false; });
    std::this_thread::sleep_for(std::chrono::seconds(2));
    session.key("l");
    session.wait_until("links", [](const Json &s) { return s["layers"]["links"] == true; });
    const std::string text = text_of(file); // while the window is open
    const std::size_t at = text.find("layers.mesh\nwait ");
    ASSERT_NE(at, std::string::npos) << text;
    EXPECT_GE(std::stod(text.substr(at + 17)), 1.9) << text;
    EXPECT_TRUE(text.ends_with("\nlayers.links\n")) << text;
    for (const auto &entry : std::filesystem::directory_iterator(file.parent_path()))
        EXPECT_FALSE(entry.path() != file && entry.path().filename().string().starts_with(file.filename().string())) << entry.path();
}

TEST(Record, APlaceThatCannotBeWrittenIsOneLineAndStatusFive) {
    Home home;
    Screen screen(1280, 800);
    const auto log = home.path() / "log";
    Process program({PENUMBRA_PROGRAM, "view", "--record", "/proc/no/such/folder/record.txt"},
                    {{"DISPLAY", screen.display()}, {"HOME", home.path().string()}, {"WAYLAND_DISPLAY", ""}}, home.path().string(), log.string());
    EXPECT_EQ(program.wait(60), 5);
    const std::string said = text_of(log);
    EXPECT_NE(said.find("--record"), std::string::npos) << said;
    EXPECT_EQ(std::ranges::count(said, '\n'), 1) << said;
}

/// Lines that no session of the tests above needs.
TEST(Record, ChangesHaveLines) {
    AppState state;
    const Scripted before = scripted(state);
    EXPECT_TRUE(lines_between(before, before).empty());
    const auto line = [&](auto change) {
        Scripted after = before;
        change(after);
        return joined(lines_between(before, after));
    };
    EXPECT_EQ(line([](Scripted &s) { s.place = {position_of(2, Phase::refined), 17}; }), "go 2 refine 17\n");
    EXPECT_EQ(line([](Scripted &s) { s.place = {position_of(2, Phase::refined), {}, 40}; }), "go 2 refine links 40\n");
    EXPECT_EQ(line([](Scripted &s) { s.place = {far_ahead, {}}; }), "go end\n");
    EXPECT_EQ(line([](Scripted &s) {
                  s.set.layout = Layout::wipe;
                  s.set.wipe = 0.25;
              }),
              "panes a d wipe\nwipe 0.25\n");
    EXPECT_EQ(line([](Scripted &s) { s.set.layout = Layout::difference; }), "panes a d difference\n");
    EXPECT_EQ(line([](Scripted &s) { s.caption = "Look."; }), "say Look.\n");
    EXPECT_EQ(line([](Scripted &s) { s.set.options = s.set.options.to_tolerance(0.01); }), "set --tolerance 0.01\n");
    EXPECT_EQ(line([](Scripted &s) { s.set.options.effects[Effect::colour] = Switch::off; }), "set --effect colour=off\n");
    EXPECT_EQ(line([](Scripted &s) { s.set.look.curve_filter.kinds = {}; }), "show --curve-kinds none\n");
    EXPECT_EQ(line([](Scripted &s) { s.pictures = {PictureSize::full_hd, 2, true, false}; }), "pictures 1920x1080 2 transparent no-labels\n");
    EXPECT_EQ(line([](Scripted &s) { s.inspector = Inspector::cost; }), "view.cost\n");
    EXPECT_EQ(line([](Scripted &s) {
                  s.set.layout = Layout::two;
                  s.set.steps_unlinked = true;
                  s.set.look.exposure_ev = 1;
                  s.set.pane_tones.emplace();
                  (*s.set.pane_tones)[0].range = Range{0, 2};
                  (*s.set.pane_tones)[1].exposure_ev = 1;
              }),
              "panes a d\nview.unlink_steps\nshow --exposure 1\nview.unlink_tones\nview.next_pane\nshow --exposure 0 --range "
              "0:2\nview.next_pane\n");
    EXPECT_EQ(line([](Scripted &s) {
                  s.set.layout = Layout::two;
                  s.set.pane_sets[1].active = 0;
                  s.set.pane_sets[1].reconstructed[0] = true;
              }),
              "panes a d\nview.next_pane\nstrategy.reconstructed\n");
}

TEST(Record, ActionsThatAreRecordedByEffectAreThere) {
    int n = 0;
    for (const Action &action : actions())
        n += action.by_effect;
    EXPECT_EQ(n, 17);
}

} // namespace
} // namespace penumbra::gui
