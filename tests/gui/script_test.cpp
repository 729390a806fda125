// Scripts that do in the window what they say, the palette, undo and redo.
#include "gui/session.h"

#include "action.h"
#include "palette.h"

#include <gtest/gtest.h>

#include <fstream>

namespace penumbra::gui {
namespace {

std::filesystem::path written(const std::string &text) {
    const auto file = std::filesystem::path(testing::TempDir()) / "lecture.txt";
    std::ofstream(file) << text;
    return file;
}

TEST(Scripts, DoWhatTheySayLineByLine) {
    const auto pictures = std::filesystem::path(testing::TempDir()) / "script-pictures";
    std::filesystem::remove_all(pictures);
    std::filesystem::create_directories(pictures);
    Session session({"--pictures", pictures.string(), "--pace", "0", "--script", written(R"(
# two strategies beside each other
open skew-blockers
view.two
panes a d
solve.step 2
set --threshold 0.05 --order 3
show --exposure 1.5 --view "3 -4 3 0 0 0 35"
say Uniform and discontinuity meshing.
picture one.png
go 1 gather
wait 100
)").string()});
    const Json s = session.wait_until("the end", [](const Json &now) { return now["script"]["line"] == 12 && !now["script"]["playing"]; }, 60);
    EXPECT_EQ(s["scene"], "skew-blockers");
    EXPECT_EQ(s["strategies"], (Json{"uniform-constant", "discontinuity-wavelet"}));
    EXPECT_EQ(s["position"], 2);
    EXPECT_EQ(s["options"]["threshold"], 0.05);
    EXPECT_EQ(s["options"]["order"], 3);
    EXPECT_EQ(s["exposure"], 1.5);
    EXPECT_EQ(s["camera"]["eye"], (Json{3.0, -4.0, 3.0}));
    EXPECT_EQ(s["caption"], "Uniform and discontinuity meshing.");
    EXPECT_TRUE(std::filesystem::exists(pictures / "one.png"));
}

TEST(Scripts, EscStopsOne) {
    Session session({"--script", written("layers.mesh\nwait 1000\nlayers.curves\n").string()});
    session.wait_until("its second line", [](const Json &s) { return s["script"]["line"] == 2; });
    session.key("Escape");
    const Json s = session.wait_until("no script", [](const Json &now) { return now["script"]["playing"] == false; });
    EXPECT_EQ(s["layers"]["mesh"], false);
    EXPECT_EQ(s["layers"]["curves"], true);
}

TEST(Undo, BringsBackOptionsPanesAndView) {
    Session session;
    const Json first = session.settled();
    session.click("order 2");
    session.wait_until("order 2", [](const Json &s) { return s["options"]["order"] == 2; });
    session.settled();
    session.key("f");
    session.wait_until("another eye", [&](const Json &s) { return s["camera"]["eye"] != first["camera"]["eye"]; });
    session.settled();
    session.key("ctrl+2");
    const Json last = session.wait_until("two panes", [](const Json &s) { return s["layout"] == "two"; });
    session.settled();
    EXPECT_EQ(session.state()["changes"]["past"], 3);
    session.key("ctrl+z");
    session.wait_until("one pane", [](const Json &s) { return s["layout"] == "single"; });
    session.key("ctrl+z");
    session.key("ctrl+z");
    const Json back = session.wait_until("the first order", [](const Json &s) { return s["options"]["order"] == 4; });
    EXPECT_EQ(back["changes"]["past"], 0);
    for (int i = 0; i < 3; ++i)
        session.key("ctrl+y");
    const Json again = session.wait_until("all of it again", [](const Json &s) { return s["layout"] == "two"; });
    EXPECT_EQ(again["options"]["order"], 2);
    EXPECT_EQ(again["camera"], last["camera"]);
    EXPECT_EQ(again["changes"]["future"], 0);
}

TEST(Palette, WordsAreFoundWhereTitlesBeginFirst) {
    AppState state;
    state.bundled_scenes = {"figure-4", "table"};
    const auto first = [&](const char *typed) {
        const auto all = palette_entries(state, typed);
        return all.empty() ? std::string() : all.front().title;
    };
    EXPECT_EQ(first("mesh"), "Mesh");
    EXPECT_EQ(first("four"), "Four panes");
    EXPECT_EQ(first("panes two"), "Two panes");
    EXPECT_EQ(first("TABLE"), "Open table");
    EXPECT_EQ(first("gouraud"), "Linear");
    EXPECT_EQ(first("xyzzy"), "");
    // There is nothing to restore, nor to discard.
    EXPECT_EQ(palette_entries(state, "").size(), actions().size() - 2 + state.bundled_scenes.size());
    state.orphans = {"/autosave-1.penumbra.json"};
    EXPECT_EQ(first("restore"), "Restore what was shown");
    EXPECT_EQ(first("discard"), "Discard what was shown");
}

TEST(Palette, EnterDoesWhatIsChosen) {
    Session session;
    session.key("ctrl+k");
    session.wait_until("the palette", [](const Json &s) { return s["palette"] == true; });
    session.settled();
    session.type("false colour");
    session.wait_until("found", [](const Json &s) { return s["found"] == "False colour"; });
    session.enter();
    const Json s = session.wait_until("false colour", [](const Json &now) { return now["false_colour"] == true; });
    EXPECT_EQ(s["palette"], false);
}

} // namespace
} // namespace penumbra::gui
