#include "core/percent.h"

#include <cmath>
#include <cstdio>

namespace penumbra {

std::string percent(double share) {
    const double x = 100 * share;
    char text[400]; // the largest double has 309 digits
    // 9.96 has to become 10, not 10.0: whether a decimal is due is asked of the rounded value.
    const bool whole = std::abs(x) >= 9.95 || !std::isfinite(x);
    if (whole)
        std::snprintf(text, sizeof text, "%.0f %%", x);
    else
        std::snprintf(text, sizeof text, "%.2g %%", x);
    return text;
}

} // namespace penumbra
