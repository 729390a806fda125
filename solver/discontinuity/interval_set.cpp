#include "discontinuity/interval_set.h"

#include <algorithm>

namespace penumbra {

void IntervalSet::unite(const Interval &interval, double gap) {
    if (interval.empty())
        return;
    Interval joined = interval;
    std::vector<Interval> rest;
    for (const Interval &i : intervals_) {
        if (i.high + gap < joined.low || i.low - gap > joined.high)
            rest.push_back(i);
        else
            joined = {std::min(i.low, joined.low), std::max(i.high, joined.high)};
    }
    rest.insert(std::ranges::lower_bound(rest, joined.low, {}, &Interval::low), joined);
    intervals_ = std::move(rest);
}

void IntervalSet::subtract(const Interval &interval) {
    if (interval.empty())
        return;
    std::vector<Interval> rest;
    for (const Interval &i : intervals_) {
        for (const Interval &piece : {overlap(i, {-std::numeric_limits<double>::infinity(), interval.low}),
                                      overlap(i, {interval.high, std::numeric_limits<double>::infinity()})})
            if (!piece.empty())
                rest.push_back(piece);
    }
    intervals_ = std::move(rest);
}

void IntervalSet::clip(const Interval &interval) {
    for (Interval &i : intervals_)
        i = overlap(i, interval);
    std::erase_if(intervals_, [](const Interval &i) { return i.empty(); });
}

void IntervalSet::clip(const IntervalSet &other) {
    std::vector<Interval> common;
    for (const Interval &i : intervals_)
        for (const Interval &j : other.intervals_)
            if (const Interval both = overlap(i, j); !both.empty())
                common.push_back(both);
    intervals_ = std::move(common);
}

void IntervalSet::split(double at) {
    for (std::size_t k = 0; k < intervals_.size(); ++k) {
        Interval &i = intervals_[k];
        if (i.low < at && at < i.high) {
            const Interval upper{at, i.high};
            i.high = at;
            intervals_.insert(intervals_.begin() + static_cast<std::ptrdiff_t>(k) + 1, upper);
            return;
        }
    }
}

void IntervalSet::split(std::vector<double> places) {
    std::ranges::sort(places);
    std::vector<Interval> pieces;
    auto place = places.begin();
    for (Interval i : intervals_) {
        place = std::upper_bound(place, places.end(), i.low);
        for (; place != places.end() && *place < i.high; ++place)
            if (*place > i.low) {
                pieces.push_back({i.low, *place});
                i.low = *place;
            }
        pieces.push_back(i);
    }
    intervals_ = std::move(pieces);
}

void IntervalSet::drop_shorter(double length) {
    std::erase_if(intervals_, [&](const Interval &i) { return i.length() < length; });
}

} // namespace penumbra
