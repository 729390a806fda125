// The record of a solution, as `penumbra solve` writes it.
#pragma once

#include "core/counters.h"
#include "core/options.h"
#include "iteration/snapshot.h"
#include "study/health.h"
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace penumbra {

struct Record {
    std::string scene; ///< as it was asked for
    Options options;
    std::vector<Counters> iterations = {};
    std::shared_ptr<const Snapshot> solution = nullptr; ///< none when it was interrupted before there was one
    std::optional<Health> health = {};                  ///< of the solution
    std::optional<double> predicted_seconds = {};       ///< to the tolerance, when the error was first measured on the way
    std::string stopped_by = {};                        ///< "interrupt", "time limit", "memory limit"; empty: nothing
};

/// JSON as the contract has it; fields whose capability is still to come are null, and so are all of `final` without a
/// solution.
std::string to_json(const Record &record);

} // namespace penumbra
