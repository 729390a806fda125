#include "discontinuity/merge_curves.h"

#include "discontinuity/interval_set.h"
#include "discontinuity/receiver_line.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
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
            // Its kind and what its lines of sight touch are those of the longest member within it.
            Curve curve = *std::ranges::max_element(std::ranges::subrange(first, last), {}, [&](const Curve &c) {
                return overlap(interval(c), i).length();
            });
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

namespace {

bool same_pair(const Curve &a, const Curve &b) { return a.source == b.source && a.receiver == b.receiver; }

/// Straight curves, those in line with each other together. They are found by a number that depends smoothly on the
/// line and not on its direction; what the tolerance of in_line leaves open of it grows as a curve gets shorter.
struct Collinear {
    static constexpr double short_length = 1e-5; // below it the direction says too little
    static constexpr double slack = 5e-3; // above 2 coincidence / short_length times the key's slope, about 10

    std::vector<std::vector<Curve>> lines;
    std::multimap<double, std::size_t> by_key;
    std::vector<std::size_t> short_lines; ///< too short to have a key

    static double key(const Curve &c) {
        const Vec2 d = (c.to - c.from).normalized(), normal(-d.y(), d.x());
        const Vec2 foot = normal.dot(c.from) * normal; // of the origin
        return foot.x() + 0.618 * foot.y() + 0.414 * (d.x() * d.x() - d.y() * d.y()) + 1.464 * d.x() * d.y();
    }

    void add(const Curve &curve) {
        const bool is_short = (curve.to - curve.from).norm() < short_length;
        std::size_t found = lines.size();
        const auto consider = [&](std::size_t line) {
            if (line < found && same_pair(lines[line][0], curve) && in_line(lines[line][0], curve))
                found = line;
        };
        const double k = is_short ? 0 : key(curve);
        const auto first = is_short ? by_key.begin() : by_key.lower_bound(k - slack);
        const auto last = is_short ? by_key.end() : by_key.upper_bound(k + slack);
        for (auto line = first; line != last; ++line)
            consider(line->second);
        std::ranges::for_each(short_lines, consider);
        if (found < lines.size()) {
            lines[found].push_back(curve);
            return;
        }
        if (is_short)
            short_lines.push_back(lines.size());
        else
            by_key.emplace(k, lines.size());
        lines.push_back({curve});
    }
};

/// Whether the arcs have five points in common, which determine a conic: both ends have weight 1, so that equal arcs have
/// equal points at equal parameters, or at opposite ones.
bool repeats(const Curve &a, const Curve &b) {
    const auto same_points = [&](bool reversed) {
        return std::ranges::all_of(std::array{0.0, 0.25, 0.5, 0.75, 1.0}, [&](double t) {
            return (point_at(a, t) - point_at(b, reversed ? 1 - t : t)).norm() <= 2 * coincidence;
        });
    };
    return same_pair(a, b) && (same_points(false) || same_points(true));
}

void add_arc(const Curve &arc, std::vector<Curve> &arcs) {
    const auto twin = std::ranges::find_if(arcs, [&](const Curve &other) { return repeats(arc, other); });
    if (twin == arcs.end()) {
        arcs.push_back(arc);
        return;
    }
    std::vector<SurfaceId> blockers;
    std::ranges::set_union(twin->blockers, arc.blockers, std::back_inserter(blockers));
    if (arc.order < twin->order)
        *twin = arc;
    twin->blockers = std::move(blockers);
}

} // namespace

std::vector<Curve> merge_curves(const std::vector<Curve> &curves) {
    Collinear lines;
    std::vector<Curve> arcs;
    for (const Curve &curve : curves)
        if (curve.straight())
            lines.add(curve);
        else
            add_arc(curve, arcs);
    std::vector<Curve> merged;
    for (std::vector<Curve> &members : lines.lines)
        std::ranges::move(merge_line(std::move(members)), std::back_inserter(merged));
    std::ranges::move(arcs, std::back_inserter(merged));
    return merged;
}

} // namespace penumbra
