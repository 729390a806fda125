// Error against price while one steps: the plot of `penumbra cost`, of the states that the window has come to.
#pragma once

#include "plot/cost_measure.h"
#include "plot/plot.h"
#include "price_book.h"

#include <vector>

namespace penumbra {

/// One run of one strategy in the plot.
struct LiveRun {
    PricedRun states;
    int here = -1;        ///< position that a pane shows; -1: none
    bool earlier = false; ///< with other options than now: fainter, and not joined
};

/// A curve for each run, its marks in the order of the states; one label for each strategy. Errors that are estimated, not
/// known, are hollow.
Plot live_cost_plot(const std::vector<LiveRun> &runs, CostMeasure measure, Theme theme);

} // namespace penumbra
