// The ledger of effects: what was decided about each, deciding otherwise, and seeing what that changes.
#pragma once

#include "app_state.h"
#include "effects/ledger.h"

#include <span>

namespace penumbra {

/// Of what the active pane shows; empty before anything is known.
std::span<const LedgerEntry> effects_ledger(const AppState &state);

/// Starts anew with this switch. What had come to its end goes to the end again.
void set_effect(AppState &state, Effect effect, Switch value);
/// Leaves all to the scene again.
void decide_by_scene(AppState &state);
bool all_by_scene(const AppState &state);

/// What there is to compare an effect with: off where it is simulated, on where it is not.
EffectChange opposite(const LedgerEntry &entry);
/// Shows what that changes in place of the light, at the end of the course; or shows the light again.
void show_change(AppState &state, const EffectChange &change);

} // namespace penumbra
