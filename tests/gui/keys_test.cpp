// Every action of the registry in the real window, by its first key and found in the palette: what it must change is written
// here, and the same must change nothing when actions are made to do nothing (the control).
#include "gui/session.h"

#include "action.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace penumbra::gui {
namespace {

/// What an action must change: a place in the reported state (JSON pointer) and, where it can be said beforehand, the
/// value found there afterwards. `before` are actions that make the ground for it.
struct Expected {
    std::string place;
    Json after; ///< null: anything else than before
    std::vector<std::string> before;
};

const std::map<std::string, Expected> &expectations() {
    static const std::map<std::string, Expected> all{
        {"check.all", {"/shelf/cases/plain/0", "ok", {}}},
        {"file.open", {"/open_dialog", true, {}}},
        {"edit.undo", {"/exposure", 0.0, {"view.exposure_0", "view.brighter"}}},
        {"edit.redo", {"/exposure", 0.5, {"view.exposure_0", "view.brighter", "edit.undo"}}},
        {"edit.palette", {"/palette", true, {}}},
        {"file.state", {"/saved", nullptr, {}}},
        {"file.picture", {"/picture", nullptr, {}}},
        {"file.compare_picture", {"/picture", nullptr, {}}},
        {"file.sequence", {"/picture", nullptr, {}}},
        {"file.copy_command", {"/pictures/command", nullptr, {}}},
        {"file.window_picture", {"/picture", nullptr, {}}},
        {"solve.play", {"/playing", true, {"solve.reset"}}},
        {"solve.step", {"/position", 3, {"solve.reset"}}},
        {"solve.sub_step", {"/position", 1, {"solve.reset"}}},
        {"solve.back", {"/position", 0, {"solve.reset", "solve.step"}}},
        {"solve.sub_back", {"/position", 2, {"solve.reset", "solve.step"}}},
        {"solve.split", {"/split", 1, {"solve.reset", "solve.step"}}},
        {"solve.split_back", {"/position", 3, {"solve.reset", "solve.step", "solve.split"}}},
        {"solve.link", {"/linking", 1, {"solve.reset", "solve.step"}}},
        {"solve.link_back", {"/linking", nullptr, {"solve.reset", "solve.link"}}},
        {"solve.next_cut", {"/split", nullptr, {"solve.reset"}}},
        {"solve.animate", {"/animates_splits", false, {}}},
        {"solve.slower", {"/speed", nullptr, {}}},
        {"solve.faster", {"/speed", nullptr, {}}},
        {"view.before", {"/before", true, {"solve.reset", "solve.step"}}},
        {"solve.reset", {"/position", 0, {"solve.reset", "solve.sub_step"}}},
        {"solve.end", {"/panes/0/converged", true, {"solve.reset"}}},
        {"solve.cancel", {"/playing", false, {"solve.reset", "solve.play"}}},
        {"strategy.a", {"/strategies/0", "uniform-constant", {}}},
        {"strategy.b", {"/strategies/0", "discontinuity-constant", {}}},
        {"strategy.c", {"/strategies/0", "uniform-wavelet", {}}},
        {"strategy.d", {"/strategies/0", "discontinuity-wavelet", {"strategy.a"}}},
        {"strategy.meshing", {"/strategies/0", "uniform-wavelet", {"strategy.d"}}},
        {"strategy.basis", {"/strategies/0", "discontinuity-constant", {"strategy.d"}}},
        {"strategy.reconstructed", {"/reconstructed/0", true, {"strategy.b"}}},
        {"view.single", {"/layout", "single", {"view.two"}}},
        {"view.two", {"/layout", "two", {}}},
        {"view.four", {"/layout", "four", {}}},
        {"view.wipe", {"/layout", "wipe", {}}},
        {"view.flip", {"/layout", "flip", {}}},
        {"view.difference", {"/layout", "difference", {}}},
        {"view.unlink", {"/cameras", nullptr, {"view.two"}}},
        {"view.unlink_tones", {"/tones", nullptr, {"view.two"}}},
        {"view.unlink_steps", {"/positions", nullptr, {"view.two"}}},
        {"view.lecture", {"/ui_scale", 1.5, {}}},
        {"view.compare", {"/strategies", Json{"uniform-wavelet", "discontinuity-wavelet"}, {"strategy.d"}}},
        {"view.inspect", {"/layers/links", true, {}}},
        {"view.figure", {"/background", "light", {}}},
        {"view.bookmark", {"/bookmarks/0/scene", "figure-4", {}}},
        {"view.bookmarks", {"/inspector", "bookmarks", {}}},
        {"edit.copy_view", {"/message", nullptr, {"view.single"}}},
        {"edit.paste_view", {"/camera/eye", nullptr, {"edit.copy_view", "view.fit"}}},
        {"view.next_layout", {"/layout", "two", {}}},
        {"view.next_pane", {"/active", nullptr, {"view.two"}}},
        {"view.fit", {"/camera/eye", nullptr, {}}},
        {"view.reset", {"/camera/eye", nullptr, {"view.fit"}}},
        {"view.brighter", {"/exposure", 0.5, {"view.exposure_0"}}},
        {"view.darker", {"/exposure", -0.5, {"view.exposure_0"}}},
        {"view.exposure_0", {"/exposure", 0.0, {"view.exposure_0", "view.brighter"}}},
        {"view.keyhole", {"/looking/open", true, {}}},
        {"view.inspector", {"/inspector", "element", {}}},
        {"view.filters", {"/inspector", "filters", {}}},
        {"view.hard_cases", {"/inspector", "hard_cases", {"view.filters"}}},
        {"view.cost", {"/inspector", "cost", {}}},
        {"view.effects", {"/inspector", "effects", {}}},
        {"view.objects", {"/inspector", "objects", {}}},
        {"view.panels", {"/panels_hidden", true, {}}},
        {"view.theme", {"/background", "light", {}}},
        {"view.larger", {"/ui_scale", nullptr, {}}},
        {"view.smaller", {"/ui_scale", nullptr, {}}},
        {"layers.mesh", {"/layers/mesh", false, {}}},
        {"layers.curves", {"/layers/curves", false, {}}},
        {"layers.links", {"/layers/links", true, {}}},
        {"layers.fresh", {"/layers/fresh", false, {}}},
        {"layers.next_shading", {"/shading", "flat", {}}},
        {"layers.polynomial", {"/shading", "polynomial", {"layers.flat"}}},
        {"layers.flat", {"/shading", "flat", {}}},
        {"layers.linear", {"/shading", "linear", {}}},
        {"layers.error", {"/shading", "error", {}}},
        {"error.next", {"/error/kind", nullptr, {"layers.error"}}},
        {"error.signed", {"/error/kind", "signed", {"error.relative"}}},
        {"error.relative", {"/error/kind", "relative", {"layers.error"}}},
        {"error.patch", {"/error/kind", "patch", {"layers.error"}}},
        {"error.estimate", {"/error/kind", "estimate", {"layers.error"}}},
        {"layers.lock_range", {"/error/locked", true, {"layers.error"}}},
        {"view.profile", {"/profiling/open", true, {}}},
        {"layers.false_colour", {"/false_colour", true, {}}},
        {"layers.legend", {"/layers/legend", false, {}}},
        {"help.keys", {"/help", true, {}}},
        {"help.tour", {"/tour/open", true, {}}},
    };
    return all;
}

/// Left again afterwards by the same key, so that it can't disturb what follows.
const std::set<std::string> switches{"file.open",          "solve.play", "solve.animate", "view.panels",  "view.theme", "view.unlink", "view.unlink_tones", "view.unlink_steps", "view.keyhole",
                                     "view.inspector", "view.filters",       "view.hard_cases", "view.cost", "view.effects", "view.objects", "view.profile", "layers.error", "layers.lock_range", "edit.palette",
                                     "layers.mesh",        "layers.curves", "layers.links", "layers.fresh",
                                     "layers.false_colour", "layers.legend", "help.keys", "help.tour"};

/// The registry's words in xdotool's.
std::string xdotool_key(std::string key) {
    std::string modifiers;
    for (const auto &[word, name] : {std::pair<std::string, std::string>{"Ctrl+", "ctrl+"}, {"Shift+", "shift+"}})
        if (key.starts_with(word)) {
            modifiers += name;
            key = key.substr(word.size());
        }
    const std::map<std::string, std::string> names{{"Space", "space"}, {"?", "question"}, {"+", "plus"}, {"-", "minus"},
                                                   {",", "comma"},     {".", "period"}};
    if (const auto found = names.find(key); found != names.end())
        key = found->second;
    if (key.size() == 1)
        key[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(key[0])));
    return modifiers + key;
}

/// Types its name into the palette and confirms.
void find_and_do(Session &session, const std::string &id) {
    session.key("ctrl+k");
    if (id == "edit.palette") // to type its name would open it twice
        return;
    session.settled();
    session.type(id);
    session.settled();
    session.enter();
}

void press(Session &session, const std::string &id) {
    const Action *action = find_action(id);
    ASSERT_NE(action, nullptr) << id;
    if (action->keys.empty())
        find_and_do(session, id);
    else
        session.key(xdotool_key(std::string(action->keys.front())));
}

Json at(const Json &state, const std::string &place) {
    const Json::json_pointer pointer(place);
    return state.contains(pointer) ? state.at(pointer) : Json();
}

TEST(Keys, EveryActionIsTested) {
    for (const Action &action : actions()) {
        // These: below, in effects_test.cpp, shelf_test.cpp, objects_test.cpp, bookmarks_test.cpp picture_test.cpp and keeping_test.cpp.
        const bool own_test = action.id == "file.quit" || action.id == "effects.by_scene" || action.id == "check.stop" || action.id == "edit.put_back" ||
                              action.id == "view.next_bookmark" || action.id == "view.previous_bookmark" ||
                              action.id == "file.picture_settings" || action.id == "file.restore" || action.id == "file.discard";
        EXPECT_NE(own_test, expectations().contains(std::string(action.id))) << action.id << " has no test, or two";
        EXPECT_GT(action.help.size(), 10u) << action.id;
    }
    for (const auto &[id, expected] : expectations())
        EXPECT_NE(find_action(id), nullptr) << id << " is no action";
}

/// Leaves what the presets and others have turned on, so that it can't disturb what follows.
void tidy(Session &session) {
    const Json s = session.settled();
    const auto leave = [&](bool on, const std::string &id) {
        if (on)
            press(session, id);
    };
    leave(s["shading"] == "error", "layers.error");
    leave(s["shading"] != "error" && s["range_chosen"] == true, "layers.lock_range");
    leave(s["panels_hidden"] == true, "view.panels");
    leave(s["background"] == "light", "view.theme");
    leave(s["layers"]["links"] == true, "layers.links");
    if (const std::string inspector = s["inspector"]; inspector != "none")
        press(session, inspector == "element" ? "view.inspector" : "view." + inspector);
}

class Way : public testing::TestWithParam<bool> {};

TEST_P(Way, EveryActionDoesWhatItSays) {
    const bool by_palette = GetParam();
    Session session;
    for (const auto &[id, expected] : expectations()) {
        SCOPED_TRACE(id);
        for (const std::string &earlier : expected.before) {
            press(session, earlier);
            const Expected &its = expectations().at(earlier);
            if (!its.after.is_null())
                session.wait_until(earlier, [&](const Json &s) { return at(s, its.place) == its.after; });
            if (earlier != "solve.play")
                session.settled();
        }
        const Json before = at(session.state(), expected.place);
        if (!expected.after.is_null()) {
            EXPECT_NE(before, expected.after) << expected.place << " holds the value already: the test would prove nothing";
        }
        const bool held = find_action(id)->release != nullptr && !by_palette;
        const std::string key = xdotool_key(find_action(id)->keys.empty() ? "" : std::string(find_action(id)->keys.front()));
        by_palette ? find_and_do(session, id) : held ? session.hold(key) : press(session, id);
        session.wait_until(id + " changes " + expected.place, [&](const Json &s) {
            const Json now = at(s, expected.place);
            return expected.after.is_null() ? now != before : now == expected.after;
        });
        if (find_action(id)->release) {
            held ? session.let_go(key) : find_and_do(session, id);
            session.wait_until(id + " ends", [&](const Json &s) { return at(s, expected.place) == before; });
        }
        if (switches.contains(id))
            press(session, id);
        tidy(session);
        if (id.starts_with("view.") && id != "view.single")
            press(session, "view.single");
        if (id.starts_with("strategy."))
            press(session, "strategy.d");
        session.settled();
    }
}

INSTANTIATE_TEST_SUITE_P(Both, Way, testing::Bool(), [](const auto &way) { return way.param ? "palette" : "key"; });

TEST(Keys, TheControlFails) {
    Session session({"--inert"});
    for (const auto &[id, expected] : expectations()) {
        SCOPED_TRACE(id);
        const Json before = at(session.state(), expected.place);
        press(session, id);
        session.settled();
        EXPECT_EQ(at(session.state(), expected.place), before);
    }
}

TEST(Keys, CtrlQEndsTheProgram) {
    Session session;
    session.key("ctrl+q");
    EXPECT_EQ(session.program().wait(10), 0);
}

TEST(Keys, AKeyInATextFieldIsText) {
    Session session;
    session.key("ctrl+o");
    session.wait_until("the dialog", [](const Json &s) { return s["open_dialog"] == true; });
    session.settled();
    const Json before = session.state();
    session.type("me1?");
    session.settled();
    EXPECT_EQ(session.state()["layers"], before["layers"]);
    EXPECT_EQ(session.state()["strategies"], before["strategies"]);
    EXPECT_EQ(session.state()["exposure"], before["exposure"]);
    EXPECT_EQ(session.state()["help"], false);
    session.key("Escape");
    session.wait_until("no dialog", [](const Json &s) { return s["open_dialog"] == false; });
}

} // namespace
} // namespace penumbra::gui
