// Parts of a line: where along it something holds.
#pragma once

#include <limits>
#include <span>
#include <vector>

namespace penumbra {

struct Interval {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();

    double length() const { return high - low; }
    double middle() const { return (low + high) / 2; }
    bool empty() const { return !(low < high); }
};

/// The interval between two parameters in either order.
inline Interval between(double s, double t) { return s < t ? Interval{s, t} : Interval{t, s}; }
inline Interval overlap(const Interval &a, const Interval &b) {
    return {a.low > b.low ? a.low : b.low, a.high < b.high ? a.high : b.high};
}

/// Disjoint intervals of positive length in ascending order.
class IntervalSet {
public:
    IntervalSet() = default;
    explicit IntervalSet(const Interval &interval) { unite(interval); }

    bool empty() const { return intervals_.empty(); }
    std::span<const Interval> intervals() const { return intervals_; }

    /// Intervals that come within `gap` of each other become one.
    void unite(const Interval &interval, double gap = 0);
    void subtract(const Interval &interval);
    void clip(const Interval &interval);
    void clip(const IntervalSet &other);
    /// Cuts the intervals at a parameter; the pieces stay in the set.
    void split(double at);
    /// The same at many.
    void split(std::vector<double> places);
    /// Drops what is shorter than `length`.
    void drop_shorter(double length);

private:
    std::vector<Interval> intervals_;
};

} // namespace penumbra
