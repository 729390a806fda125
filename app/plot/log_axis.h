// A logarithmic axis: its range, its ticks and their words.
#pragma once

#include <limits>
#include <string>
#include <vector>

namespace penumbra {

/// What an axis counts, which says how its numbers are written: 1000, 10⁴; 10 ms, 1 s; 1 %, 0.01 %.
enum class PlotUnit { count, seconds, share };

struct LogAxis {
    double low = 1, high = 10; ///< 0 < low < high
    PlotUnit unit = PlotUnit::count;

    /// 0 at low, 1 at high.
    double place(double value) const;
};

/// Collects the values that an axis should show.
class AxisRange {
public:
    /// Not positive and not finite ones are left out.
    void add(double value);
    /// From the least to the largest value with a margin of 6 % of its length (in decades) at both ends, and at least one
    /// decade long; 1 to 10 where there was no value.
    LogAxis axis(PlotUnit unit) const;

private:
    double low_ = std::numeric_limits<double>::infinity(), high_ = 0;
};

struct Tick {
    double value = 0;
    bool major = false; ///< a power of ten
    std::string label;  ///< empty: none
};

/// All m·10^k in the range, m = 1 to 9, in ascending order. Powers of ten are labelled, every second or third one where
/// more than `most_labels` fall into the range; where two or fewer do, 2·10^k and 5·10^k are labelled, too, if all of
/// these are no more than `most_labels`.
std::vector<Tick> ticks(const LogAxis &axis, int most_labels = 6);

/// "1000", "10⁴", "2·10⁵"; "20 ms", "1 s"; "0.01 %". For m·10^k with one digit m.
std::string tick_words(double value, PlotUnit unit);

} // namespace penumbra
