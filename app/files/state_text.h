// What the window shows, as a state to be kept and as tests of the window read it.
#pragma once

#include "app_state.h"
#include "files/saved_state.h"

#include <filesystem>
#include <string>

namespace penumbra {

/// All that is needed to see the same again, for a file in that folder. The position is the one that is shown.
SavedState saved_state(const AppState &state, const std::filesystem::path &folder);

/// The above as JSON, with the position that was asked for, and what the window is doing: figures of the panes, whether
/// it is busy, its message, where its controls are [screen coordinates: x, y, width, height].
std::string observed_state_text(const AppState &state);

} // namespace penumbra
