// What accuracy costs, as a table for scripts.
#pragma once

#include "study/cost.h"

#include <string>
#include <vector>

namespace penumbra {

/// A study of one scene, with what its times hang on.
struct CostStudy {
    std::string scene;
    std::string cpu; ///< empty: not known
    int cores = 1, threads = 1;
    std::string version; ///< of the program
    int repeats = 1; ///< asked for
    RunLimits limits;
    std::vector<CostPoint> points;
    double reference_error = 0; ///< of what errors are measured against, its own; 0: exact
};

/// A line for each strategy, basis and threshold, in that order. Columns:
///   strategy, basis, order, threshold, max_depth
///   status       done, not converged, time limit, memory limit, failed, not tried (a looser threshold of this strategy
///                and basis was not done), interrupted
///   runs         to the fixed point
///   seconds, seconds_min, seconds_max   median and extremes of these runs; of a run that was stopped: how long it took
///   patches, coefficients, links, kernel_evaluations, error   of the last complete iteration; error: true, relative L2
///   iterations, clips, nodes_at_limit   nodes_at_limit: patches that the depth limit has kept from being split
///   scene, cpu, cores, threads, version, reference_error
/// What is not known is empty. Fields with a comma or a quotation mark stand in quotation marks (RFC 4180).
std::string cost_csv(const CostStudy &study);

} // namespace penumbra
