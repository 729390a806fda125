// Where the oracle has to look in a penumbra.
#pragma once

#include "hierarchy/forest.h"
#include "visibility/visible_part.h"

#include <span>
#include <vector>

namespace penumbra {

/// Where shadows fall on p: the centres of the blockers as seen from the source's centre (a shadow smaller than the
/// element), and the middles of their edges as seen from the source's corners (where penumbras begin and end); at most
/// 24, evenly thinned. Drawn in by 2 % as test points are: on a border that lies in the source's plane (a box that stands
/// on the source) T has no value. And, at most 24 more, both sides of the lines along which blockers go through p: T
/// jumps there, and no fit can be near on both, while other points may all lie where it happens to be near.
std::vector<Vec2> shadow_points(const Scene &scene, const Blockers &blockers, const Element &p, const Surface &source,
                                std::span<const PairBlocker> pair);

} // namespace penumbra
