// What panes share, and what each may have of its own.
#pragma once

#include "app_state.h"

namespace penumbra {

/// Makes this pane the active one, with its own step, exposure and ranges where panes have their own.
void activate(AppState &state, int pane);
void set_layout(AppState &state, Layout layout);
/// One of the two strategies that are compared, in one pane; where that is shown already, the other in its place.
void flip(AppState &state);

/// Each gives every pane one of its own, at first the same; or all of them the active pane's.
void toggle_cameras(AppState &state);
void toggle_tones(AppState &state); ///< exposure and ranges
void toggle_steps(AppState &state);

void set_tone(AppState &state, int pane, const Tone &tone);
/// Those of errors, when errors of another kind and unit are shown.
void forget_error_ranges(AppState &state);
/// Ranges that nobody has chosen: one for all panes, or for each its own, over all steps that were computed so far, so that
/// stepping does not change the scale.
void update_ranges(AppState &state);

/// Keeps what is the active pane's own among that of the other panes, before another pane or layout becomes active; and takes
/// it from there afterwards.
void put_away_own(AppState &state);
void take_up_own(AppState &state);

} // namespace penumbra
