#include "visibility/visible_part.h"

#include <cmath>
#include <utility>

namespace penumbra {

namespace {

constexpr double edge_on = 1e-13;

/// Points y of the plane with n.(y - x) >= 0, scaled so that values are distances from the plane n.
HalfPlane trace(const Vec3 &n, const Vec3 &x, const PlaneFrame &plane) {
    return {n.dot(plane.u), n.dot(plane.v), n.dot(plane.origin - x)};
}

} // namespace

void HiddenRegions::cast(const Vec3 &x, const PlaneFrame &source, const Blockers &blockers,
                         std::span<const PairBlocker> pair, Work &work) {
    half_planes_.clear();
    first_.assign(1, 0);
    for (const PairBlocker &candidate : pair) {
        const Blocker &b = blockers[candidate.blocker];
        const double height = b.frame.height(x);
        if (std::abs(height) <= edge_on || (candidate.front_only && height < 0))
            continue;
        const double towards = height > 0 ? -1 : 1;
        // Beyond the blocker's plane, as seen from x.
        half_planes_.push_back(trace(towards * b.frame.normal, b.frame.origin, source));
        for (std::size_t i = 0; i < b.corners.size(); ++i) {
            const Vec3 from = b.corners[i] - x, to = b.corners[i + 1 < b.corners.size() ? i + 1 : 0] - x;
            half_planes_.push_back(trace(towards * from.cross(to), x, source));
        }
        first_.push_back(half_planes_.size());
        ++work.clips;
    }
}

void visible_part(const Vec3 &x, const Vec3 &n, const PlaneFrame &source, const ConvexPieces &whole,
                  const HiddenRegions &hidden, VisibleScratch &scratch) {
    scratch.pieces.clear();
    if (source.height(x) <= 0)
        return;
    clip(whole, trace(n, x, source), scratch.pieces);
    for (std::size_t i = 0; i < hidden.size() && !scratch.pieces.empty(); ++i) {
        subtract(scratch.pieces, hidden[i], scratch.next);
        std::swap(scratch.pieces, scratch.next);
    }
}

} // namespace penumbra
