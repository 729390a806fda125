// From the accuracy asked for to thresholds, and when to stop.
#pragma once

#include "iteration/state.h"

namespace penumbra {

/// The threshold to begin with: Options::threshold; on the way to a tolerance a loose one, since early pictures should
/// come fast and what comes after shows how the error falls (Hanrahan, Salzman & Aupperle 1991).
double first_threshold(const Options &options);

/// Fills estimated_error, error_limit and error_bound with what fresh points say of this state (measure_error.h).
/// `goal`: what the error is to be compared with; 0: nothing.
void measure(const Setting &setting, State &state, double goal, const Cancel *cancel);

/// After each iteration. With a threshold a settled state has converged. With a tolerance a settled state is measured: it
/// has converged if the estimate's upper limit is below the tolerance; else the threshold in force falls, by less than the
/// error has to, since errors fall in leaps. Where the state has not changed since it was measured, it falls without a
/// new measurement; where it cannot fall any more the state is exhausted.
void control(const Setting &setting, State &state, const Cancel *cancel);

} // namespace penumbra
