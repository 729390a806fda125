// What `penumbra check` found, for reading and for scripts.
#pragma once

#include "study/hard_cases.h"
#include "study/health.h"

#include <string>
#include <vector>

namespace penumbra {

/// A line for each measurement, under one that says what must hold; of those common to all cases only what fails,
/// unless `all` are asked for.
std::string check_text(const std::vector<CaseResult> &results, bool all = false);
/// A list of {name, what, basis, holds, measurements: [{quantity, value, bound, holds}]}; a value that is not finite is
/// null.
std::string check_json(const std::vector<CaseResult> &results);

/// The health of one scene's solution.
struct SceneHealth {
    std::string scene;
    BasisFamily basis = BasisFamily::parametric;
    Health health;
    Counters counters;
    double peak = 0; ///< largest reflected radiosity [W/m2]
};

/// A line each. Least radiosity is given as a fraction of the peak.
std::string health_text(const std::vector<SceneHealth> &scenes);
/// A list of {scene, basis, energy_balance_error, absorbed, lost, drift, closure_error (null in open scenes),
/// max_gram_error, min_radiosity, peak, max_filter_condition, non_finite, links, nodes_at_limit, converged}.
std::string health_json(const std::vector<SceneHealth> &scenes);

} // namespace penumbra
