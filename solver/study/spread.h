// How far repeated measurements lie apart.
#pragma once

#include <vector>

namespace penumbra {

struct Spread {
    double median = 0, low = 0, high = 0;
};

/// Median (of an even number: the mean of the two in the middle), least and largest. All 0 when there are none.
Spread spread_of(std::vector<double> values);

} // namespace penumbra
