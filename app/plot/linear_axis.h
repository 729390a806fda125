// A linear axis: its range, its ticks and their words.
#pragma once

#include "plot/log_axis.h"

#include <vector>

namespace penumbra {

struct LinearAxis {
    double low = 0, high = 1; ///< low < high

    /// 0 at low, 1 at high.
    double place(double value) const { return (value - low) / (high - low); }
    /// The reverse.
    double value(double place) const { return low + place * (high - low); }
};

/// From the least to the largest value with a margin of this part of its length at both ends; 0 to 1 where there are
/// none. Values that are not finite are left out; where all are the same, the axis is as long as they are large.
LinearAxis linear_axis(const std::vector<double> &values, double margin);

/// Every 1, 2 or 5 times a power of ten, at most `most_labels` of them, all labelled, with as many decimals as tell
/// them apart (a power of ten beyond 10^5, "2·10⁶"), and unlabelled ones at a fifth (or a half, of 2) of that.
std::vector<Tick> ticks(const LinearAxis &axis, int most_labels = 6);

} // namespace penumbra
