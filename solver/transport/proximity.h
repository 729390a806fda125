// How near an element and a source come to each other.
#pragma once

#include "hierarchy/forest.h"

#include <vector>

namespace penumbra {

/// Least distance of a corner of the one (element p of surface `to`, surface `from`) from the other: an upper bound of
/// the distance of the two, and 0 where they touch at a corner or along an edge [solver units].
double corner_distance(const Element &p, const Surface &to, const Surface &from);

/// Corners of the source that touch p (to within 1e-9), in p's plane: ends of a common edge.
std::vector<Vec2> touching_corners(const Element &p, const Surface &to, const Surface &from);

} // namespace penumbra
