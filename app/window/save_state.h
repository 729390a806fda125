// States saved from the window.
#pragma once

#include "app_state.h"

#include <filesystem>

namespace penumbra {

/// As a numbered file NAME.penumbra.json beside the pictures. Says in the message which file it became, or why there is
/// none.
void save_state(AppState &state);

/// For when the program can't go on: to $XDG_STATE_HOME/penumbra/rescued.penumbra.json, over the one before. Returns
/// the file; throws Unavailable where it can't be written.
std::filesystem::path rescue_state(const AppState &state);

} // namespace penumbra
