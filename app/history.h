// Undo and redo, of every parameter and of the view. Steps are no changes: they have a way back of their own.
#pragma once

#include "app_state.h"

#include <string>

namespace penumbra {

Parameters parameters(const AppState &state);

/// Looks at what has changed since the last call; to be called when nothing is held or typed. The camera alone, moved again
/// within a second, is one change. What is older than two hundred changes falls away.
void note_changes(AppState &state, Clock::time_point now);
/// Another scene was opened: there is no way back to what was set for the one before.
void forget_changes(AppState &state);

bool can_undo(const AppState &state);
bool can_redo(const AppState &state);
void undo(AppState &state);
void redo(AppState &state);

/// "the view", "the options and the panes": what differs.
std::string change_words(const Parameters &a, const Parameters &b);

} // namespace penumbra
