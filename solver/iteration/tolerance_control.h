// From the accuracy asked for to thresholds, and when to stop.
#pragma once

#include "iteration/state.h"

namespace penumbra {

/// The threshold to begin with: the tolerance's own, or Options::threshold.
double first_threshold(const Options &options);

/// After each iteration. With a threshold a settled state has converged. With a tolerance the error of a settled state is
/// measured (measure_error.h, fresh points each time): it has converged if the estimate's upper limit is below the
/// tolerance; else the threshold in force falls by as much as the error has to, with a margin. Where the state has not
/// changed since it was measured, it falls without a new measurement; where it cannot fall any more, or only nodes at
/// limits fail, the state is exhausted.
void control(const Setting &setting, State &state, const Cancel *cancel);

} // namespace penumbra
