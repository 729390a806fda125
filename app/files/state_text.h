// The state as readable JSON: what every picture carries, and what tests of the window read.
#pragma once

#include "app_state.h"

#include <string>

namespace penumbra {

/// Scene, options, step, strategies, camera, layers and range: all that is needed to see the same again.
std::string saved_state_text(const AppState &state);

/// The above and what the window is doing: figures of the panes, whether it is busy, its message, where its controls
/// are [screen coordinates: x, y, width, height].
std::string observed_state_text(const AppState &state);

} // namespace penumbra
