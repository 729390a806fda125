// The shelf of hard cases: looking at them and checking them.
#pragma once

#include "app_state.h"
#include "check_worker.h"
#include "core/options.h"

#include <optional>

namespace penumbra {

/// Puts the cases on it, once.
void fill_shelf(AppState &state);
/// Checks all of them anew, or stops that.
void check_shelf(AppState &state);
void stop_check(AppState &state);
/// Shows the case's scene, in that basis, or in the present one.
void open_case(AppState &state, std::size_t index, std::optional<BasisFamily> basis = std::nullopt);
/// Takes over what the worker says.
void apply(AppState &state, const CheckReport &report);

/// Verdicts of that status, over both bases.
int n_verdicts(const Shelf &shelf, CaseStatus status);

} // namespace penumbra
