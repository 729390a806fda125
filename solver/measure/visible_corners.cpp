#include "measure/visible_corners.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace penumbra {

namespace {

using Sector = std::pair<double, double>; ///< angles, counter-clockwise, the second larger
constexpr double turn = 2 * std::numbers::pi;
constexpr double straight = 1e-6; ///< angles that differ by less are the same

double angle(const Vec2 &d) { return std::atan2(d.y(), d.x()); }

/// What the piece covers of a small circle about p; nothing where p is not on its border.
void add_sector(std::span<const Vec2> piece, const Vec2 &p, double slack, std::vector<Sector> &sectors) {
    const std::size_t n = piece.size();
    const auto add = [&](const Vec2 &from, const Vec2 &to) {
        const double start = angle(from);
        double width = angle(to) - start;
        width += width < 0 ? turn : 0;
        sectors.emplace_back(start, start + width);
    };
    for (std::size_t i = 0; i < n; ++i)
        if ((piece[i] - p).norm() <= slack)
            return add(piece[(i + 1) % n] - piece[i], piece[(i + n - 1) % n] - piece[i]);
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2 side = piece[(i + 1) % n] - piece[i], to = p - piece[i];
        const double length = side.norm(), along = to.dot(side) / length;
        if (along > 0 && along < length && std::abs(cross(side, to)) <= slack * length)
            return add(side, -side);
    }
}

/// Whether the sectors together are anything but the whole circle or one half of it.
bool turns(std::vector<Sector> sectors) {
    for (std::size_t i = 0, n = sectors.size(); i < n; ++i) // once more a turn later, so that all runs are seen whole
        sectors.emplace_back(sectors[i].first + turn, sectors[i].second + turn);
    std::ranges::sort(sectors);
    int n_gaps = 0;
    double gap = 0, end = sectors.front().second;
    for (const auto &[from, to] : sectors) {
        if (from > end + straight && from < sectors.front().first + turn + straight) {
            ++n_gaps;
            gap = from - end;
        }
        end = std::max(end, to);
    }
    return n_gaps > 1 || (n_gaps == 1 && std::abs(gap - std::numbers::pi) > straight);
}

} // namespace

std::vector<Vec2> corners_of_union(const ConvexPieces &pieces, double slack) {
    std::vector<Vec2> points, corners;
    for (std::size_t i = 0; i < pieces.size(); ++i)
        for (const Vec2 &p : pieces[i])
            if (std::ranges::none_of(points, [&](const Vec2 &q) { return (p - q).norm() <= slack; }))
                points.push_back(p);
    std::vector<Sector> sectors;
    for (const Vec2 &p : points) {
        sectors.clear();
        for (std::size_t i = 0; i < pieces.size(); ++i)
            add_sector(pieces[i], p, slack, sectors);
        if (!sectors.empty() && turns(sectors))
            corners.push_back(p);
    }
    return corners;
}

} // namespace penumbra
