#include "iteration/tolerance_control.h"

#include "core/percent.h"
#include "iteration/measure_error.h"

#include <algorithm>
#include <string>

namespace penumbra {

namespace {

constexpr double margin = 0.8;                     // of what the threshold has to fall by
constexpr double least_factor = 0.1, most_factor = 0.7;
constexpr double floor_share = 0.01;               // of the tolerance: no threshold below it is tried

} // namespace

double first_threshold(const Options &options) { return options.tolerance.value_or(options.threshold); }

void control(const Setting &setting, State &state, const Cancel *cancel) {
    Counters &c = state.counters;
    if (!setting.options.tolerance) {
        c.converged = c.settled;
        return;
    }
    if (!c.settled)
        return;
    const double tolerance = *setting.options.tolerance;
    if (c.estimated_error < 0) {
        Work work;
        const ErrorEstimate e =
            measure_error(setting, state, tolerance, static_cast<std::uint64_t>(c.iteration), cancel, work);
        c.work += work;
        c.total_work += work;
        c.estimated_error = e.error;
        c.error_bound = e.bound;
        c.error_limit = e.upper;
    }
    const std::string found = "measured at fresh points, the error is about " + percent(c.estimated_error) + " (at most " +
                              percent(c.error_bound) + ")";
    if (c.error_limit <= tolerance) {
        c.converged = true;
        state.sentence = "converged: " + found + ", below the " + percent(tolerance) + " asked for";
        return;
    }
    if (c.threshold <= floor_share * tolerance) {
        c.exhausted = true;
        state.sentence = found + "; the " + percent(tolerance) + " asked for is out of reach";
        return;
    }
    c.threshold = std::max(c.threshold * std::clamp(margin * tolerance / c.error_limit, least_factor, most_factor),
                           floor_share * tolerance);
    state.sentence = found + ", and " + percent(tolerance) + " was asked for: the oracle's threshold falls to " +
                     percent(c.threshold);
}

} // namespace penumbra
