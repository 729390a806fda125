#include "hierarchy/planar_split.h"

#include "core/check.h"

#include <algorithm>
#include <cmath>

namespace penumbra {

namespace {

constexpr double reach = 1e-6; // of the frame's unit, as snap_reach in cut.h: nearer corners are on the line, and a part
                               // must be wider

struct Part {
    Polygon corners;
    std::vector<SideKind> sides;

    void add(const Vec2 &corner, SideKind side) {
        corners.push_back(corner);
        sides.push_back(side);
    }
};

/// The least extent of a convex polygon across one of its sides.
double width(const Polygon &corners) {
    double least = 2;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec2 side = corners[(i + 1) % corners.size()] - corners[i];
        double most = 0;
        for (const Vec2 &p : corners)
            most = std::max(most, std::abs(cross(side, p - corners[i])));
        if (!side.isZero(0))
            least = std::min(least, most / side.norm());
    }
    return least;
}

} // namespace

HalfPlane in_own_frame(const PlanarDomain &domain, const HalfPlane &line) {
    const Affine &m = domain.to_plane();
    const Vec2 normal = m.linear.transpose() * Vec2(line.a, line.b);
    return {normal.x(), normal.y(), line.value(m.offset)};
}

std::optional<std::array<PlanarPiece, 2>> split(const PlanarDomain &domain, const std::vector<SideKind> &sides,
                                                const HalfPlane &line, SideKind new_side, int &n_snapped) {
    const Polygon &corners = domain.corners();
    const std::size_t n = corners.size();
    PENUMBRA_CHECK(sides.size(), ==, n);
    const double scale = std::hypot(line.a, line.b);
    std::vector<double> height;
    for (const Vec2 &p : corners) {
        const double h = line.value(p) / scale;
        n_snapped += h != 0 && std::abs(h) < reach;
        height.push_back(std::abs(h) < reach ? 0 : h);
    }
    std::array<Part, 2> parts; // the second one on the line's other side
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t j = (i + 1) % n;
        for (std::size_t k = 0; k < 2; ++k) {
            const double turn = k == 0 ? 1 : -1, here = turn * height[i], next = turn * height[j];
            if (here >= 0 && next >= 0)
                parts[k].add(corners[i], sides[i]);
            else if (here == 0)
                parts[k].add(corners[i], new_side);
            else if (here > 0)
                parts[k].add(corners[i], sides[i]);
        }
        if (height[i] * height[j] < 0) {
            const Vec2 at = corners[i] + height[i] / (height[i] - height[j]) * (corners[j] - corners[i]);
            const std::size_t left = height[i] > 0 ? 0 : 1;
            parts[left].add(at, new_side);
            parts[1 - left].add(at, sides[i]);
        }
    }
    for (const Part &part : parts)
        if (part.corners.size() < 3 || width(part.corners) <= reach)
            return std::nullopt;
    return std::array<PlanarPiece, 2>{PlanarPiece{domain.part(parts[0].corners), std::move(parts[0].sides)},
                                      PlanarPiece{domain.part(parts[1].corners), std::move(parts[1].sides)}};
}

std::array<PlanarPiece, 2> bisected(const PlanarDomain &domain, const std::vector<SideKind> &sides) {
    const Eigen::Matrix2d &box = domain.to_plane().linear;
    const bool along_x = box.col(0).squaredNorm() >= box.col(1).squaredNorm();
    int n_snapped = 0;
    auto halves = split(domain, sides, along_x ? HalfPlane{-1, 0, 0.5} : HalfPlane{0, -1, 0.5}, SideKind::uniform,
                        n_snapped);
    PENUMBRA_CHECK(halves.has_value(), ==, true);
    return *std::move(halves);
}

} // namespace penumbra
