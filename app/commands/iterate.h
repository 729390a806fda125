// Steps on the way to the fixed point.
#pragma once

#include "commands/progress.h"
#include "core/cancel.h"
#include "iteration/solver.h"

#include <memory>
#include <vector>

namespace penumbra {

/// Steps until converged, or `most` steps were done. When cancelled the solver is left at its last complete iteration.
/// Returns the counters after each step. `best`, where given: of the states whose error was measured on the way, the one
/// with the least; null when there was none.
std::vector<Counters> iterate(Solver &solver, int most, const Cancel &cancel, Progress &progress,
                              std::shared_ptr<const State> *best = nullptr);

} // namespace penumbra
