#include "discontinuity/sweep.h"

#include <algorithm>
#include <array>

namespace penumbra {

void Crossing::add(const Vec3 &x, const Vec3 &direction) {
    if (n == 0)
        p = q = x;
    else if ((x - p).dot(direction) < 0)
        p = x;
    else if ((x - q).dot(direction) > 0)
        q = x;
    ++n;
}

Crossing cross_facet(const Wedge &wedge, const Facet &facet) {
    Crossing crossing;
    const Vec3 direction = wedge.normal.cross(facet.normal);
    const std::size_t n = facet.corners.size();
    int previous = wedge.side(facet.corners[n - 1]);
    for (std::size_t i = 0; i < n; ++i) {
        const Vec3 &corner = facet.corners[i];
        const int side = wedge.side(corner);
        crossing.left |= side > 0;
        crossing.right |= side < 0;
        if (side == 0) {
            crossing.add(corner, direction);
        } else if (side * previous < 0) {
            const Vec3 &before = facet.corners[(i + n - 1) % n];
            const double h = std::abs(wedge.height(corner)), h_before = std::abs(wedge.height(before));
            crossing.add(before + h_before / (h + h_before) * (corner - before), direction);
        }
        previous = side;
    }
    return crossing;
}

Sweep sweep(const SourceView &view, const Wedge &wedge, Reach reach, std::span<const std::size_t> at_apex,
            IntervalSet candidates) {
    Sweep result{std::move(candidates), {}};
    for (std::size_t f = 0; f < view.facets.size() && !result.open.empty(); ++f) {
        const Facet &facet = view.facets[f];
        if (std::abs(wedge.height(facet.centre)) > facet.radius + coincidence || std::ranges::binary_search(at_apex, f))
            continue;
        const Crossing crossing = cross_facet(wedge, facet);
        if (!crossing.through() && !crossing.along_edge())
            continue;
        std::array<Interval, 2> lines{wedge.below(crossing.p, crossing.q), Interval{0, 0}};
        if (reach == Reach::beyond_apex)
            lines[1] = wedge.above(crossing.p, crossing.q);
        for (const Interval &interval : lines) {
            if (interval.empty())
                continue;
            if (crossing.through())
                result.open.subtract(interval);
            else
                result.grazes.push_back({interval, crossing.p, crossing.q, crossing.left ? 1 : -1, facet.surface});
        }
    }
    return result;
}

bool on_line(const Graze &graze, const Vec3 &p, const Vec3 &q) {
    const Vec3 direction = (q - p).normalized();
    const auto off = [&](const Vec3 &x) { return direction.cross(x - p).norm(); };
    return off(graze.p) <= 2 * coincidence && off(graze.q) <= 2 * coincidence;
}

void close_folds(Sweep &sweep) {
    for (std::size_t i = 0; i < sweep.grazes.size(); ++i)
        for (std::size_t j = i + 1; j < sweep.grazes.size(); ++j) {
            const Graze &one = sweep.grazes[i], &other = sweep.grazes[j];
            if (one.side != other.side && on_line(one, other.p, other.q))
                sweep.open.subtract(overlap(one.lines, other.lines));
        }
}

} // namespace penumbra
