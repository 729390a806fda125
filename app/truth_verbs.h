// How wrong the solutions are: what has to be found out for the error pictures and the profile, and what has been.
#pragma once

#include "app_state.h"
#include "truth_worker.h"

namespace penumbra {

/// What the worker should find out; nothing (no scene) unless error pictures or a profile are shown.
TruthGoal truth_goal(const AppState &state);
/// Takes over what the worker says.
void apply(AppState &state, const TruthReport &report);

/// The map of what a pane shows; null: not known, or not of this step.
std::shared_ptr<const ErrorMap> errors_of(const AppState &state, int pane);
/// What is subtracted from the second pane, where the layout shows the difference; null: it does not, or that is not known.
std::shared_ptr<const Snapshot> subtracted(const AppState &state);
/// What the picture of a difference shows under the mouse, by channel [W/m2]; none: no such picture, or nothing there.
std::optional<Rgb> difference_under_cursor(const AppState &state);
/// Equal in all panes: unless it is locked it follows what they show, as soon as all of it is known.
void update_error_ranges(AppState &state);
/// Shows this kind of error. The range of another kind is let go.
void show_errors(AppState &state, ErrorKind kind);
/// Keeps the range through steps and strategies, or lets it follow them again.
void toggle_range_lock(AppState &state);
/// Gives up finding out until something is asked for again.
void stop_judging(AppState &state);

} // namespace penumbra
