#include "plot/linear_axis.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace penumbra {

namespace {

std::string words(double value, double step) {
    if (std::abs(value) < 1e-9 * step)
        return "0";
    const int decimals = static_cast<int>(std::ceil(-std::log10(step) - 1e-9));
    if (decimals > 5 || std::abs(value) >= 1e5)
        return (value < 0 ? "\u2212" : "") + fmt::format("{:.3g}", std::abs(value));
    return (value < 0 ? "\u2212" : "") + fmt::format("{:.{}f}", std::abs(value), std::max(0, decimals));
}

/// The least of 1, 2 and 5 times a power of ten that is not below `least`.
double round_step(double least) {
    const double power = std::pow(10.0, std::floor(std::log10(least) + 1e-9));
    for (const double m : {1.0, 2.0, 5.0})
        if (m * power >= least * (1 - 1e-9))
            return m * power;
    return 10 * power;
}

} // namespace

LinearAxis linear_axis(const std::vector<double> &values, double margin) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const double v : values)
        if (std::isfinite(v)) {
            low = std::min(low, v);
            high = std::max(high, v);
        }
    if (low > high)
        return {};
    if (high - low <= 1e-12 * std::max(std::abs(low), std::abs(high))) {
        const double reach = std::max(std::abs(low), 1e-300) / 2;
        return low == 0 && high == 0 ? LinearAxis{-0.5, 0.5} : LinearAxis{low - reach, high + reach};
    }
    const double more = margin * (high - low);
    return {low - more, high + more};
}

std::vector<Tick> ticks(const LinearAxis &axis, int most_labels) {
    const double length = axis.high - axis.low, rough = length / std::max(1, most_labels);
    double step = round_step(rough);
    // No multiple of it may lie on a short axis: then the next smaller one, so that some number stands there.
    while (std::floor(axis.high / step + 1e-9) < std::ceil(axis.low / step - 1e-9))
        step = round_step(0.4 * step);
    const bool of_two = std::abs(step / std::pow(10.0, std::floor(std::log10(step) + 1e-9)) - 2) < 0.5;
    const int parts = of_two ? 2 : 5;
    const double minor = step / parts;
    std::vector<Tick> all;
    for (double k = std::ceil(axis.low / minor - 1e-9); k * minor <= axis.high + 1e-9 * length; ++k) {
        const bool major = std::fmod(std::abs(k), parts) == 0;
        all.push_back({k * minor, major, major ? words(k * minor, step) : ""});
    }
    return all;
}

} // namespace penumbra
