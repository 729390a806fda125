#include "orphan_verbs.h"

namespace penumbra {

bool has_orphan(const AppState &state) { return !state.orphans.empty(); }

void restore_orphan(AppState &state) { state.open_request = state.orphans.front(); }

void discard_orphan(AppState &state) { state.discard_request = true; }

} // namespace penumbra
