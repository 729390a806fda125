// Which curves lie between two points of a receiver.
#pragma once

#include "iteration/snapshot.h"

#include <compare>
#include <vector>

namespace penumbra {

struct CurveCrossing {
    double part = 0; ///< of the way, in [0, 1)
    int curve = 0;   ///< of snapshot.curves
    auto operator<=>(const CurveCrossing &) const = default;
};

/// Where the segment crosses curves on the surface (points in the scene's own frame), in its order.
std::vector<CurveCrossing> crossed_curves(const Snapshot &snapshot, int surface, const Vec3 &from, const Vec3 &to);

} // namespace penumbra
