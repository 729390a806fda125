// The actions of each menu, which action.cpp makes one list of.
#pragma once

#include "action.h"

#include <vector>

namespace penumbra {

std::vector<Action> file_actions();
std::vector<Action> edit_actions();
std::vector<Action> solve_actions();
std::vector<Action> strategy_actions();
std::vector<Action> view_actions();
std::vector<Action> layer_actions();
std::vector<Action> help_actions();

bool has_scene(const AppState &state);
/// Of the active pane, at the step that is shown.
bool has_solution(const AppState &state);
bool can_go_back(const AppState &state);

} // namespace penumbra
