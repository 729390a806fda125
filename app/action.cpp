#include "action.h"

#include "menu_actions.h"
#include "paper_lines.h"

#include <algorithm>
#include <iterator>

namespace penumbra {

namespace {

const std::vector<Action> &list() {
    static const std::vector<Action> all = [] {
        std::vector<Action> actions;
        for (auto menu : {file_actions, edit_actions, solve_actions, strategy_actions, view_actions, layer_actions, help_actions})
            std::ranges::move(menu(), std::back_inserter(actions));
        for (Action &action : actions)
            action.paper = paper_line(action.id);
        return actions;
    }();
    return all;
}

} // namespace

bool has_scene(const AppState &s) { return s.scene != nullptr; }
bool has_solution(const AppState &s) { return has_scene(s) && s.snapshot(s.active_strategy()); }
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
    action.run(state);
    return true;
}

} // namespace penumbra
