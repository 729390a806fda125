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
    void (*release)(AppState &) = nullptr; ///< null: done when the key goes down; else it lasts until the key goes up
    bool passing = false; ///< left out of menus and palette while it is disabled
    bool by_effect = false; ///< recorded by what it has changed, not by its name
    std::string paper = {}; ///< symbol and equation; see paper_lines.h. Empty: there is none
};

/// In the order of the menus.
std::span<const Action> actions();
/// Null when there is none of that name, or on that key.
const Action *find_action(std::string_view id);
const Action *action_on_key(std::string_view key);
/// Of the actions that last while this key, told without modifiers, is down.
void release_key(std::string_view key, AppState &state);

bool is_enabled(const Action &action, const AppState &state);
bool is_checked(const Action &action, const AppState &state);
/// Whether menus and palette have it now.
bool is_offered(const Action &action, const AppState &state);
/// From a menu or the palette: one that lasts while its key is held begins, or ends if it lasts already.
void choose(const Action &action, AppState &state);
/// Does it, if it is enabled. Returns whether it was.
bool run(const Action &action, AppState &state);

} // namespace penumbra
