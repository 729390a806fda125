#include "iteration/tolerance_control.h"

#include "core/percent.h"
#include "iteration/measure_error.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace penumbra {

namespace {

// Figures behind these: tests/bench/README.md.
constexpr double loosest = 0.3;                    // threshold
constexpr double first_share = 3;                  // threshold over tolerance, where the tolerance is looser than that
constexpr double margin = 0.9;                     // of what the error has to fall by
constexpr double error_by_threshold = 1.5;         // assumed: errors fall by this power of the threshold
constexpr double least_factor = 0.1, most_factor = 0.7, blind_factor = 0.35; // blind: no tolerance to aim at
constexpr double floor_share = 0.01;               // of the tolerance: no threshold below it is tried
constexpr double lowest = 1e-7;                    // threshold: below it, rounding and the moments' accuracy are what is left

double next_threshold(const Counters &c, double tolerance) {
    if (tolerance == 0)
        return std::max(blind_factor * c.threshold, lowest);
    const double wanted = std::pow(margin * tolerance / c.error_limit, 1 / error_by_threshold);
    return std::max({c.threshold * std::clamp(wanted, least_factor, most_factor), floor_share * tolerance, lowest});
}

} // namespace

double first_threshold(const Options &options) {
    return options.tolerance ? std::max(loosest, first_share * *options.tolerance) : options.threshold;
}

void measure(const Setting &setting, State &state, double goal, const Cancel *cancel) {
    Counters &c = state.counters;
    Work work;
    const ErrorEstimate e = measure_error(setting, state, goal, static_cast<std::uint64_t>(c.iteration), cancel, work);
    c.work += work;
    c.total_work += work;
    c.estimated_error = e.error;
    c.error_bound = e.bound;
    c.error_limit = e.upper;
}

void control(const Setting &setting, State &state, const Cancel *cancel) {
    Counters &c = state.counters;
    if (!setting.options.tolerance) {
        c.converged = c.settled;
        return;
    }
    if (!c.settled)
        return;
    const double tolerance = *setting.options.tolerance;
    if (c.estimated_error < 0)
        measure(setting, state, tolerance, cancel);
    const std::string found = "measured at fresh points, the error is about " + error_in_words(c);
    if (c.error_limit <= tolerance) {
        c.converged = true;
        state.sentence = "converged: " + found + (tolerance > 0 ? ", below the " + percent(tolerance) + " asked for" : "");
        return;
    }
    if (c.threshold <= std::max(floor_share * tolerance, lowest)) {
        (tolerance > 0 ? c.exhausted : c.converged) = true;
        state.sentence = found + (tolerance > 0 ? "; the " + percent(tolerance) + " asked for is out of reach"
                                                : "; no smaller one is within reach");
        return;
    }
    c.threshold = next_threshold(c, tolerance);
    state.sentence = found + (tolerance > 0 ? ", and " + percent(tolerance) + " was asked for" : "") +
                     ": the oracle's threshold falls to " + percent(c.threshold);
}

} // namespace penumbra
