#include "discontinuity/merge_curves.h"

#include "discontinuity/interval_set.h"
#include "discontinuity/receiver_line.h"

#include <algorithm>
#include <tuple>

namespace penumbra {

namespace {

/// What wins where curves coincide.
std::tuple<int, bool> rank(const Curve &c) { return {c.order, c.kind == CurveKind::plane}; }

/// All curves in line with each other, as intervals of their common line.
std::vector<Curve> merge_line(std::vector<Curve> members) {
    std::ranges::stable_sort(members, {}, rank);
    // The longest gives the direction best.
    const Curve base = *std::ranges::max_element(members, {}, [](const Curve &c) { return (c.to - c.from).norm(); });
    const Vec2 foot = base.from, along = (base.to - base.from).normalized();
    const auto interval = [&](const Curve &c) { return between((c.from - foot).dot(along), (c.to - foot).dot(along)); };
    std::vector<Curve> merged;
    IntervalSet taken;
    for (auto first = members.begin(); first != members.end();) {
        const auto last = std::find_if(first, members.end(), [&](const Curve &c) { return rank(c) != rank(*first); });
        IntervalSet own;
        for (auto c = first; c != last; ++c)
            own.unite(interval(*c), shortest_curve);
        for (const Interval &i : taken.intervals())
            own.subtract(i);
        own.drop_shorter(shortest_curve);
        for (const Interval &i : own.intervals()) {
            Curve curve = *first;
            curve.from = foot + i.low * along;
            curve.to = foot + i.high * along;
            curve.blockers.clear();
            for (auto c = first; c != last; ++c)
                if (overlap(interval(*c), i).length() > 0)
                    curve.blockers.insert(curve.blockers.end(), c->blockers.begin(), c->blockers.end());
            std::ranges::sort(curve.blockers);
            const auto twins = std::ranges::unique(curve.blockers);
            curve.blockers.erase(twins.begin(), twins.end());
            merged.push_back(std::move(curve));
        }
        for (const Interval &i : own.intervals())
            taken.unite(i);
        first = last;
    }
    return merged;
}

} // namespace

bool in_line(const Curve &a, const Curve &b) {
    const Curve &base = (a.to - a.from).squaredNorm() > (b.to - b.from).squaredNorm() ? a : b;
    const Curve &other = &base == &a ? b : a;
    const Vec2 along = (base.to - base.from).normalized();
    return std::abs(cross(along, other.from - base.from)) <= 2 * coincidence &&
           std::abs(cross(along, other.to - base.from)) <= 2 * coincidence;
}

std::vector<Curve> merge_curves(const std::vector<Curve> &curves) {
    std::vector<std::vector<Curve>> lines;
    std::vector<Curve> merged;
    for (const Curve &curve : curves) {
        if (!curve.straight()) {
            merged.push_back(curve);
            continue;
        }
        const auto line = std::ranges::find_if(lines, [&](const std::vector<Curve> &members) {
            return members[0].source == curve.source && members[0].receiver == curve.receiver &&
                   in_line(members[0], curve);
        });
        if (line == lines.end())
            lines.push_back({curve});
        else
            line->push_back(curve);
    }
    for (std::vector<Curve> &members : lines)
        std::ranges::move(merge_line(std::move(members)), std::back_inserter(merged));
    return merged;
}

} // namespace penumbra
