// What a point sees of a source: the exact visible part (the backprojection of Drettakis & Fiume 1994).
#pragma once

#include "core/counters.h"
#include "geometry/convex_pieces.h"
#include "visibility/blockers.h"

#include <span>
#include <vector>

namespace penumbra {

/// A blocker of a receiver-source pair.
struct PairBlocker {
    int blocker = 0;
    /// The receiver lies outside the closed solid whose face it is: where the face turns away it hides nothing that the
    /// others do not.
    bool front_only = false;
};

/// The regions of a source's plane that the blockers hide from a receiver point, each as an intersection of half-planes:
/// those through the point and the blocker's edges, and the part beyond the blocker's plane.
class HiddenRegions {
public:
    /// For point x (solver coordinates) in front of `source`. A blocker seen edge-on (to within 1e-13) hides nothing.
    void cast(const Vec3 &x, const PlaneFrame &source, const Blockers &blockers, std::span<const PairBlocker> pair,
              Work &work);
    std::size_t size() const { return first_.size() - 1; }
    std::span<const HalfPlane> operator[](std::size_t i) const {
        return {half_planes_.data() + first_[i], half_planes_.data() + first_[i + 1]};
    }

private:
    std::vector<HalfPlane> half_planes_;
    std::vector<std::size_t> first_{0};
};

/// Working memory of visible_part, for one thread.
struct VisibleScratch {
    HiddenRegions hidden;
    ConvexPieces pieces, next;
};

/// The part of the source (convex polygons in the plane of `source`) in front of the plane through x with normal n and
/// outside the hidden regions: left in scratch.pieces. Empty when x is not in front of the source's plane.
void visible_part(const Vec3 &x, const Vec3 &n, const PlaneFrame &source, const ConvexPieces &whole,
                  const HiddenRegions &hidden, VisibleScratch &scratch);

} // namespace penumbra
