// Steps on the way to the fixed point.
#pragma once

#include "commands/progress.h"
#include "core/cancel.h"
#include "iteration/solver.h"

#include <vector>

namespace penumbra {

/// Steps until converged, or `most` steps were done. When cancelled the solver is left at its last complete iteration.
/// Returns the counters after each step.
std::vector<Counters> iterate(Solver &solver, int most, const Cancel &cancel, Progress &progress);

} // namespace penumbra
