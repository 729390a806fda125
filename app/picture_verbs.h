// Pictures that wait until what they show is known: of both meshings, and of every step.
#pragma once

#include "app_state.h"
#include "solve_worker.h"
#include "truth_worker.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace penumbra {

/// Uniform beside discontinuity meshing, in the active pane's basis, at its step.
void compare_meshings(AppState &state);
/// Every step from 0 to the active pane's, with the panes as they are; numbered in a new folder below the pictures'.
void picture_all_steps(AppState &state);
/// Takes no more; those that were taken stay.
void drop_pictures(AppState &state);

/// Those that a picture of the window needs; of a flip the one that is there.
std::vector<int> pictured_panes(const AppState &state);
/// What a pane of a pending picture shows; null: not known yet.
std::shared_ptr<const Snapshot> pictured(const AppState &state, const PendingPicture &picture, std::size_t pane);
/// How wrong that is; null: not known yet.
std::shared_ptr<const ErrorMap> pictured_errors(const AppState &state, const Judging &judging);

enum class Readiness { ready, waiting, hopeless };
/// Whether it can be taken now; hopeless: its solution failed, or is of another run.
Readiness readiness(const AppState &state, const PendingPicture &picture);
/// What the solver should do for the first pending picture; nothing where it has nothing to do for it.
std::optional<Goal> picture_goal(const AppState &state);
/// What should be judged for it.
std::vector<Judging> to_be_judged(const AppState &state);
/// For the status bar; empty: no picture is pending.
std::string picture_progress(const AppState &state);

} // namespace penumbra
