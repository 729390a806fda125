// What a saved state brings back into the window.
#pragma once

#include "app_state.h"
#include "files/saved_state.h"

namespace penumbra {

/// Options, panes, position, camera and look; the scene is there already. The worker computes up to the position again.
void restore(AppState &state, const SavedState &saved);

/// The same while the scene is open already: what has been computed stays, unless options or places differ.
void bring_back(AppState &state, const SavedState &saved);

/// What only a solution can tell, asked whenever one of this strategy is there: opens the keyhole where the state has
/// it, and lets go of a curve that there is not. Until then nothing of them is shown.
void find_what_was_restored(AppState &state, Strategy strategy);

} // namespace penumbra
