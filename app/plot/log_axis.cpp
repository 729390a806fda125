#include "plot/log_axis.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace penumbra {

namespace {

std::string raised(int power) {
    static constexpr const char *digits[] = {"\u2070", "\u00b9", "\u00b2", "\u00b3", "\u2074",
                                             "\u2075", "\u2076", "\u2077", "\u2078", "\u2079"};
    std::string text = power < 0 ? "\u207b" : "";
    for (const char c : std::to_string(std::abs(power)))
        text += digits[c - '0'];
    return text;
}

/// As a decimal where that is short, else with a power of ten.
std::string number(double value) {
    const int power = static_cast<int>(std::floor(std::log10(value) + 1e-9));
    if (power >= -3 && power <= 3)
        return fmt::format("{:.{}f}", value, std::max(0, -power));
    const int digit = static_cast<int>(std::lround(value / std::pow(10, power)));
    return (digit == 1 ? "" : std::to_string(digit) + "\u00b7") + "10" + raised(power);
}

} // namespace

double LogAxis::place(double value) const { return std::log(value / low) / std::log(high / low); }

void AxisRange::add(double value) {
    if (!(value > 0) || !std::isfinite(value))
        return;
    low_ = std::min(low_, value);
    high_ = std::max(high_, value);
}

LogAxis AxisRange::axis(PlotUnit unit) const {
    if (!(high_ > 0))
        return {1, 10, unit};
    const double low = std::log10(low_), high = std::log10(high_), margin = 0.06 * (high - low);
    const double more = std::max(margin, (1 - (high - low)) / 2);
    return {std::pow(10, low - more), std::pow(10, high + more), unit};
}

std::string tick_words(double value, PlotUnit unit) {
    switch (unit) {
    case PlotUnit::count:
        return number(value);
    case PlotUnit::share:
        return number(100 * value) + " %";
    case PlotUnit::seconds:
        break;
    }
    // A rounded product keeps 1e-3 from being 999.99 µs.
    const double s = value * (1 + 1e-9);
    return s < 1e-3 ? number(1e6 * value) + " \u00b5s" : s < 1 ? number(1e3 * value) + " ms" : number(value) + " s";
}

std::vector<Tick> ticks(const LogAxis &axis, int most_labels) {
    constexpr double rounding = 1e-9;
    const auto inside = [&](double v) { return v >= axis.low * (1 - rounding) && v <= axis.high * (1 + rounding); };
    const int first = static_cast<int>(std::floor(std::log10(axis.low))) - 1;
    const int last = static_cast<int>(std::ceil(std::log10(axis.high))) + 1;
    int n_decades = 0, n_between = 0; // of these, and of 2 and 5 times these
    for (int k = first; k <= last; ++k) {
        n_decades += inside(std::pow(10, k));
        n_between += inside(2 * std::pow(10, k)) + inside(5 * std::pow(10, k));
    }
    const bool between = n_decades <= 2 && n_decades + n_between <= most_labels;
    const int every = std::max(1, (n_decades + most_labels - 1) / most_labels);
    std::vector<Tick> all;
    for (int k = first; k <= last; ++k)
        for (int m = 1; m <= 9; ++m) {
            const double value = m * std::pow(10, k);
            if (!inside(value))
                continue;
            const bool labelled = m == 1 ? k % every == 0 : between && (m == 2 || m == 5);
            all.push_back({value, m == 1, labelled ? tick_words(value, axis.unit) : ""});
        }
    return all;
}

} // namespace penumbra
