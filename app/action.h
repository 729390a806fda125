// Everything that a user can do, once: menus, tool bar, keys and the help page are all made from this list.
#pragma once

#include "app_state.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace penumbra {

enum class Menu { file, edit, solve, strategy, view, layers, help };
std::string_view title(Menu menu);

struct Action {
    std::string_view id;    ///< "solve.step"; names it to scripts and tests
    Menu menu{};
    std::string_view title; ///< in menus and on buttons
    std::string_view help;  ///< one plain sentence
    std::vector<std::string_view> keys; ///< "Shift+Right", "?"; see window/keys.h. The first one is shown
    void (*run)(AppState &) = nullptr;
    bool (*enabled)(const AppState &) = nullptr; ///< null: always
    bool (*checked)(const AppState &) = nullptr; ///< null: it is no toggle
    bool passing = false; ///< left out of menus and palette while it is disabled
    std::string paper = {}; ///< symbol and equation; see paper_lines.h. Empty: there is none
};

/// In the order of the menus.
std::span<const Action> actions();
/// Null when there is none of that name, or on that key.
const Action *find_action(std::string_view id);
const Action *action_on_key(std::string_view key);

bool is_enabled(const Action &action, const AppState &state);
bool is_checked(const Action &action, const AppState &state);
/// Whether menus and palette have it now.
bool is_offered(const Action &action, const AppState &state);
/// Does it, if it is enabled. Returns whether it was.
bool run(const Action &action, AppState &state);

} // namespace penumbra
