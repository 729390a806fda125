// How a facet lies to the plane of a wedge.
#pragma once

#include "discontinuity/source_view.h"
#include "discontinuity/wedge.h"

namespace penumbra {

/// How a convex facet lies to the wedge's plane, and the segment pq that both have in common (none when n < 2).
struct Crossing {
    bool left = false, right = false; ///< corners beside the plane, on its sides +1 and -1
    int n = 0;
    Vec3 p = Vec3::Zero(), q = Vec3::Zero();

    bool through() const { return n >= 2 && left && right; }
    bool along_edge() const { return n >= 2 && left != right; }
    void add(const Vec3 &x, const Vec3 &direction);
};

Crossing cross_facet(const Wedge &wedge, const Facet &facet);

} // namespace penumbra
