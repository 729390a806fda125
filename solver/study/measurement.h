// What was measured, and the most that it may be.
#pragma once

#include <string>

namespace penumbra {

struct Measurement {
    std::string quantity;
    double value = 0;
    double bound =
        0; ///< from a closed form, a symmetry or the threshold asked for; never from the code that is measured
    bool common = false; ///< asked of every case

    /// A value that is not a number holds nothing.
    bool holds() const { return value <= bound; }
};

} // namespace penumbra
