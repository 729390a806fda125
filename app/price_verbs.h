// Prices of the states that the window has come to, and the way back to one.
#pragma once

#include "app_state.h"
#include "plot/live_cost.h"

#include <memory>
#include <optional>
#include <vector>

namespace penumbra {

/// Of all strategies: the present run first, then where the earlier ones of the scene ended. Runs without a priced state are left out.
std::vector<LiveRun> live_runs(const AppState &state);

/// Shows the state again: one of an earlier run is solved anew with its options.
void go_to_priced(AppState &state, const PricedState &priced, bool earlier);

/// What a strategy would cost for another tolerance with otherwise the present options, from all that was measured on this
/// scene; nothing where nothing was.
std::optional<Price> price_tag(const AppState &state, Strategy strategy, double tolerance);

/// Starts anew with these options, and remembers what was predicted. What had come to its end goes to the end again.
void ask_for_tolerance(AppState &state, const Options &options);

/// The strategies that the panes show, each with its state there; what is not known yet is left out.
std::vector<std::shared_ptr<const Snapshot>> compared(const AppState &state);

} // namespace penumbra
