// What solutions of the scene have cost and how wrong they were: of the present run, and of those before it.
#pragma once

#include "core/counters.h"
#include "core/options.h"
#include "study/price.h"
#include "timeline.h"

#include <array>
#include <optional>
#include <vector>

namespace penumbra {

/// A complete iteration whose error is known.
struct PricedState {
    Options options; ///< with its strategy
    int position = 0;
    Counters counters;
    double true_error = -1; ///< relative L2; negative: not known

    bool estimated() const { return true_error < 0; }
    /// The true one, or else the estimate.
    double error() const { return estimated() ? counters.estimated_error : true_error; }
};

/// Those of a timeline, in its order; errors of 0 are left out, as a logarithm cannot show them.
std::vector<PricedState> priced_states(const Timeline &timeline);

/// Of one run of one strategy.
using PricedRun = std::vector<PricedState>;

/// Runs of the present scene that were thrown away when the options changed, the oldest first. Of several with the same
/// options the last one stays.
struct PriceBook {
    std::vector<PricedRun> runs;
    /// What the present run was said to cost before it began, by strategy; nothing where nothing was known.
    std::array<std::optional<Price>, 4> predicted;

    /// What has no priced state leaves no trace.
    void keep(const Timeline &timeline);
};

} // namespace penumbra
