// What is done with the autosave of a window that ended unexpectedly; see files/autosave.h.
#pragma once

#include "app_state.h"

namespace penumbra {

/// The first one is offered.
bool has_orphan(const AppState &state);
/// Asks for it to be opened. It is no orphan any more as soon as it was read: this window goes on with it.
void restore_orphan(AppState &state);
/// Asks for it to be deleted.
void discard_orphan(AppState &state);

} // namespace penumbra
