#include "action.h"

#include "menu_actions.h"
#include "paper_lines.h"
#include "script.h"
#include "scripted.h"

#include <algorithm>
#include <iterator>

namespace penumbra {

namespace {

/// Done again by a script they would do something else: they follow the mouse, the clipboard or the moment, lie open over the
/// scene, or end what plays the script.
constexpr std::string_view recorded_by_effect[] = {
    "file.open",   "file.restore",   "file.discard",   "file.quit",    "edit.undo",    "edit.redo",
    "edit.paste_view", "edit.palette", "solve.play",   "solve.cancel", "check.stop",   "view.keyhole",
    "view.profile", "view.inspector", "view.filters",  "view.before",  "help.tour"};

const std::vector<Action> &list() {
    static const std::vector<Action> all = [] {
        std::vector<Action> actions;
        for (auto menu : {file_actions, edit_actions, solve_actions, strategy_actions, view_actions, layer_actions, help_actions})
            std::ranges::move(menu(), std::back_inserter(actions));
        for (Action &action : actions) {
            action.paper = paper_line(action.id);
            action.by_effect = std::ranges::find(recorded_by_effect, action.id) != std::end(recorded_by_effect);
        }
        return actions;
    }();
    return all;
}

} // namespace

bool has_scene(const AppState &s) { return s.scene != nullptr; }
bool has_solution(const AppState &s) { return has_scene(s) && s.active_solution(); }
bool can_go_back(const AppState &s) { return s.position > 0; }

std::string_view title(Menu menu) {
    constexpr std::string_view titles[] = {"File", "Edit", "Solve", "Strategy", "View", "Layers", "Help"};
    return titles[static_cast<std::size_t>(menu)];
}

std::span<const Action> actions() { return list(); }

const Action *find_action(std::string_view id) {
    const auto found = std::ranges::find(list(), id, &Action::id);
    return found == list().end() ? nullptr : &*found;
}

const Action *action_on_key(std::string_view key) {
    for (const Action &a : list())
        if (std::ranges::find(a.keys, key) != a.keys.end())
            return &a;
    return nullptr;
}

void release_key(std::string_view key, AppState &state) {
    for (const Action &a : list())
        if (a.release && std::ranges::any_of(a.keys, [&](std::string_view k) { return k.substr(k.rfind('+') + 1) == key; }))
            a.release(state);
}

bool is_enabled(const Action &action, const AppState &state) { return !action.enabled || action.enabled(state); }

bool is_checked(const Action &action, const AppState &state) { return action.checked && action.checked(state); }

void choose(const Action &action, AppState &state) {
    if (action.release && is_checked(action, state))
        action.release(state);
    else
        run(action, state);
}

bool is_offered(const Action &action, const AppState &state) { return !action.passing || is_enabled(action, state); }

bool run(const Action &action, AppState &state) {
    if (state.inert || !is_enabled(action, state))
        return false;
    if (state.message.error)
        state.message = {};
    if (!state.recording) {
        action.run(state);
        return true;
    }
    Deed deed{&action, std::make_shared<const Scripted>(scripted(state)), nullptr, at_rest(state)};
    action.run(state);
    deed.after = std::make_shared<const Scripted>(scripted(state));
    state.deeds.push_back(std::move(deed));
    return true;
}

} // namespace penumbra
