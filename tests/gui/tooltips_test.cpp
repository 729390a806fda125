// Every control that is drawn tells a plain sentence, and the paper's symbol where it has one, when the mouse rests on it.
#include "gui/session.h"

#include "action.h"
#include "paper_lines.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>

namespace penumbra::gui {
namespace {

bool is_exempt(const std::string &name) {
    // The scene itself, and what lies in it: these tell values and curves as the mouse moves.
    if (name.starts_with("pane ") || name == "keyhole" || name == "profile plot")
        return true;
    // What lies under the mouse is told of only while it is in a pane: the mouse can't be on these at the same time.
    if (name == "figure surface" || name == "figure patch" || name == "figure radiosity" || name == "figure reflectance" ||
        name == "figure difference")
        return true;
    // Titles of menus open them; the palette writes its sentences out; the card is no control.
    return (name.starts_with("menu.") && std::isupper(static_cast<unsigned char>(name[5])) != 0) || name.starts_with("palette") ||
           name == "tour";
}

/// Points of a plot and pieces of a sketch are told of by what they stand in.
std::string teller(const std::string &name) {
    for (const char *whole : {"cost plot", "split sketch"})
        if (name.starts_with(whole))
            return whole;
    return name.starts_with("cost point") ? "cost plot" : name;
}

class Tooltips : public testing::Test {
protected:
    Session session{{}, 1280, 2100};
    std::set<std::string> seen;

    /// High enough for all of each panel.
    Tooltips() {
        session.resize(1280, 2100);
        session.wait_until("a high window", [](const Json &s) { return s["widgets"]["course"][1].get<double>() > 1900; });
        session.settled();
    }

    /// Rests the mouse on each control that was not seen before.
    void hover_all() {
        session.move({640, 2090});
        const Json now = session.settled();
        for (const auto &[name, box] : now["widgets"].items()) {
            const double width = box[2], height = box[3];
            const bool fresh = seen.insert(name).second;
            if (!fresh || is_exempt(name) || width <= 0 || height <= 0)
                continue;
            SCOPED_TRACE(name);
            session.move({box[0].get<double>() + 0.5 * width, box[1].get<double>() + 0.5 * height});
            const Json s = session.wait_until("a sentence on " + name, [&](const Json &state) {
                return state["told"]["control"] == teller(name);
            }, 5);
            EXPECT_GT(s["told"]["title"].get<std::string>().size(), 0U);
            EXPECT_GT(s["told"]["sentence"].get<std::string>().size(), 10U);
            if (const Action *action = find_action(name)) {
                EXPECT_EQ(s["told"]["sentence"], action->help);
            }
            if (const std::string paper = paper_line(name); !paper.empty()) {
                EXPECT_EQ(s["told"]["paper"], paper);
            }
        }
    }

    /// A point of the pane where the mouse is over a patch.
    Point on_a_patch() {
        const Box pane = session.widget("pane 0");
        for (double share = 0.35; share < 0.8; share += 0.05) {
            const Point p{pane.x + 0.5 * pane.width, pane.y + share * pane.height};
            session.move(p);
            const Json under = session.settled()["under_cursor"];
            if (!under.is_null() && under["patch"].get<int>() >= 0)
                return p;
        }
        ADD_FAILURE() << "there is no patch in the middle of the pane";
        return {};
    }

    void press(const char *key) {
        session.key(key);
        session.settled();
    }
};

TEST_F(Tooltips, EveryControlTellsASentence) {
    hover_all();
    for (const char *key : {"Right", "End", "x", "Home", "Right", "t", "y", "a", "shift+F1"}) { // inspectors, errors, the tour
        press(key);
        hover_all();
    }
    for (const char *key : {"shift+F1", "x", "ctrl+4", "h"}) {
        press(key);
        hover_all();
    }
    press("h");
    for (const char *key : {"w", "shift+d"}) {
        press(key);
        hover_all();
    }
    press("ctrl+1");
    press("1"); // meets the depth limit
    press("End");
    hover_all();
    press("t");
    session.click(on_a_patch());
    session.wait_until("a split", [](const Json &s) { return s["microscope"].value("pieces", 0) == 4; });
    hover_all();
    press("t");
    press("4");
    session.click("asked tolerance");
    session.wait_until("a tolerance", [](const Json &s) { return !s["options"]["tolerance"].is_null(); });
    press("End");
    hover_all();
    press("ctrl+1");
    on_a_patch();
    const Json over_it = session.state(); // shown only while the mouse is there
    for (const auto &[name, box] : over_it["widgets"].items())
        seen.insert(name);
    press("ctrl+o");
    hover_all();
    press("Escape");
    EXPECT_GT(seen.size(), 120U);
    for (const PaperLine &line : paper_lines()) {
        const std::string name(line.name);
        EXPECT_TRUE(find_action(line.name) || seen.contains(name))
            << name << " is no action, and no control was seen of that name";
    }
}

TEST_F(Tooltips, MenusTellTheSame) {
    for (const char *menu : {"File", "Edit", "Solve", "Strategy", "View", "Layers", "Help"}) {
        const std::string title = std::string("menu.") + menu;
        session.click(title);
        session.wait_until(title, [&](const Json &s) { return !s["widgets"].contains(title); });
        const Json now = session.settled();
        for (const auto &[name, box] : now["widgets"].items()) {
            if (!name.starts_with("menu.") || is_exempt(name))
                continue;
            SCOPED_TRACE(name);
            session.move({box[0].get<double>() + 0.5 * box[2].get<double>(), box[1].get<double>() + 0.5 * box[3].get<double>()});
            const Json s = session.wait_until("a sentence", [&, n = name](const Json &state) { return state["told"]["control"] == n; }, 5);
            EXPECT_GT(s["told"]["sentence"].get<std::string>().size(), 10U);
        }
        session.click(Point{640, 2090});
        session.settled();
    }
}

TEST(PaperLines, NameEquationsThatThePaperHas) {
    std::set<std::string> names;
    for (const PaperLine &line : paper_lines()) {
        const std::string text = paper_line(line.name), place(line.place);
        EXPECT_TRUE(names.insert(std::string(line.name)).second) << line.name << " stands there twice";
        EXPECT_NE(text.find(line.symbol), std::string::npos);
        EXPECT_EQ(text.find("Bouatouch & Pattanaik 1995, ") == std::string::npos, line.of_others) << text;
        // Equations (1) to (7), sections 1 to 6, figures 1 to 8.
        for (std::size_t at = place.find('('); at != place.npos; at = place.find('(', at + 1))
            EXPECT_TRUE(place[at + 1] >= '1' && place[at + 1] <= '7' && place[at + 2] == ')') << place;
        if (const std::size_t at = place.find("section "); at != place.npos) {
            EXPECT_TRUE(place[at + 8] >= '1' && place[at + 8] <= '6') << place;
        }
        if (const std::size_t at = place.find("figure "); at != place.npos) {
            EXPECT_TRUE(place[at + 7] >= '1' && place[at + 7] <= '8') << place;
        }
    }
    EXPECT_EQ(paper_line("solve.reset"), "");
}

} // namespace
} // namespace penumbra::gui
