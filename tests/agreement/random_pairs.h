// Points and elements that see each other, by the way they lie to each other.
#pragma once

#include "basis/element_basis.h"
#include "geometry/convex_pieces.h"
#include "geometry/plane_frame.h"

#include <cstdint>
#include <string>
#include <vector>

namespace penumbra {

struct PointAndElement {
    Vec3 x, n;
    PlaneFrame source;
    ElementBasis element;
    Polygon piece; ///< convex, in front of x's plane: the element, or what is left of it
};

struct PairSort {
    std::string name;
    PointAndElement (*make)(std::uint32_t seed);
};

/// Far, near, at a common edge, at a corner, beside the source's plane, over its middle at grazing heights, slivers,
/// parametric triangles, parts of parallelograms. Elements are of order 2 to 4 and of both families in turn.
const std::vector<PairSort> &pair_sorts();

} // namespace penumbra
