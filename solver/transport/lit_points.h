// Where a source lights an element most.
#pragma once

#include "hierarchy/forest.h"

#include <vector>

namespace penumbra {

/// The points of p (in its surface's plane) nearest to those beneath the corners, the middles of the sides and the parts
/// of the source `from`, or, where it stands upright on p's plane or above it, in front of it at the distance at which it
/// lights most.
std::vector<Vec2> lit_points(const Element &p, const Surface &to, const Surface &from);

/// Whether the source lights so small a part of p that a grid over p may miss it: it is small beside p, and near.
bool lights_a_spot(const Element &p, const Surface &from, double distance);

} // namespace penumbra
