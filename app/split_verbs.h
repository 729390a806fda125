// Inside a refinement: its splits one by one, and then the pairs that it linked. While AppState::split or ::linking is set,
// every pane shows its own first ones of that number (one with fewer, all); what is counted and told is the active pane's.
#pragma once

#include "app_state.h"

#include <optional>

namespace penumbra {

/// Splits of the refinement at the present position, in the active pane; 0 at other phases and while it is not there yet.
int n_splits(const AppState &state);
/// How many of them are shown, from 1 on; none: all, without one that stands out.
std::optional<int> shown_splits(const AppState &state);

/// Shows the first k, 1 <= k <= n_splits, and tells of the last of these.
void show_splits(AppState &state, int k);
/// The smallest step there is: one split on, or, where there is none left, to the next phase. Of a refinement that is
/// entered so the first split alone is shown.
void next_split(AppState &state);
/// The way back; a refinement is entered at its last split.
void previous_split(AppState &state);

/// Pairs linked by the refinement at the present position, in the active pane, and how many of them are shown, as above.
int n_linkings(const AppState &state);
std::optional<int> shown_linkings(const AppState &state);
/// Shows all splits and the first k pairs linked, 1 <= k <= n_linkings, and tells of the last of these.
void show_linkings(AppState &state, int k);
/// One pair on or back. Where all is shown, or nothing is left, to the first one of the next refinement; before the first one,
/// to the last split.
void next_linking(AppState &state);
void previous_linking(AppState &state);

/// Goes on, refinement after refinement, until the last split shown is a cut along a curve, or there is nothing more.
void seek_cut(AppState &state);
/// The next part of that way, whenever something was computed.
void go_on_seeking(AppState &state);

/// While playing: the splits of a refinement one after the other, within a second. Returns as advance_play; none when there
/// is nothing to animate here.
std::optional<double> advance_splits(AppState &state, Clock::time_point now);
/// Begins that, where a refinement was reached by playing.
void begin_animation(AppState &state);

/// Makes the snapshots that shown_snapshot() looks for. Before each frame.
void bring_splits(AppState &state);

/// Where we stood before the last step: what `view.before` shows.
Place place_before(const AppState &state);

} // namespace penumbra
