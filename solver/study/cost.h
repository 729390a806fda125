// What accuracy costs: one scene solved again and again, by each strategy in each basis for each of a row of
// thresholds; the price of each solution stands beside its true error.
#pragma once

#include "core/cancel.h"
#include "core/counters.h"
#include "core/options.h"
#include "study/run_watch.h"
#include "study/true_error.h"

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace penumbra {

enum class RunEnd { done, not_converged, time_limit, memory_limit, failed, not_tried, interrupted };
/// `done`, `not converged`, `time limit`, ...; the public names.
std::string_view name(RunEnd end);

struct CostRange {
    std::vector<Strategy> strategies{std::begin(all_strategies), std::end(all_strategies)};
    std::vector<BasisFamily> bases{BasisFamily::parametric, BasisFamily::planar};
    std::vector<double> thresholds; ///< in any order
    int repeats = 3;                ///< of each run, 1 or more
    Options options;                ///< of all; its strategy, basis and threshold are not looked at
};

/// One solution, and what it took.
struct CostRun {
    RunEnd end = RunEnd::done;
    Counters counters;   ///< of the last complete iteration
    double seconds = 0;  ///< until the fixed point, or until it was stopped
    double error = -1;   ///< true one of the last complete iteration; negative: not known
    std::string trouble; ///< why it failed
};

/// Solves once. Repeat 0 comes first and measures the error as well; those after it need not, since results do not
/// depend on the run, and may take four times the limit of time, since the first one did not meet it. Throws Cancelled.
using CostRunner = std::function<CostRun(const Options &, int repeat)>;

/// Seconds are wall clock of the iterations and, for strategies that cut, of tracing the emitters' curves before the
/// first one; the others trace them only for the eye. The error's own time is not counted. `scene`, `error` and `cancel`
/// are kept.
CostRunner solving_runner(std::shared_ptr<const Scene> scene, TrueError error, const RunLimits &limits,
                          const Cancel &cancel);

/// One strategy in one basis at one threshold.
struct CostPoint {
    Options options;
    RunEnd end = RunEnd::not_tried;
    Counters counters;
    double error = -1;           ///< negative: not known
    std::vector<double> seconds; ///< of the runs that came to the fixed point, or of the one that did not
    std::string trouble;         ///< why it failed

    bool done() const { return end == RunEnd::done; }
    /// Times that it was solved to the fixed point.
    int n_runs() const { return done() ? static_cast<int>(seconds.size()) : 0; }
};

/// Is told after each run: the point as it is now, how many runs there were and how many there will be at most.
using CostProgress = std::function<void(const CostPoint &, int done, int all)>;

/// The points by strategy, then basis, then threshold from the loosest. A run that is thrown away comes first, for the
/// start of the threads and the caches. Then every point is solved once, strategies and bases in a shuffled order (the
/// same in every study), thresholds from the loosest: where one meets a limit or fails, the finer ones of its strategy
/// and basis would, too, and are not tried. Then those that were done are solved again, all in a shuffled order, so that
/// what else the machine does spoils no single curve. Once cancelled, the rest is `interrupted` (a point keeps the runs
/// that it has).
std::vector<CostPoint> measure_cost(const CostRange &range, const CostRunner &run, const CostProgress &told = {});

} // namespace penumbra
