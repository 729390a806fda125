// Where the oracle has to look in a penumbra.
#pragma once

#include "hierarchy/forest.h"
#include "visibility/visible_part.h"

#include <span>
#include <vector>

namespace penumbra {

/// Where shadows fall on p: the centres of the blockers as seen from the source's centre (a shadow smaller than the
/// element), and the middles of their edges as seen from the source's corners (where penumbras begin and end); at most
/// 24, evenly thinned. Drawn in by 2 %: on a border that lies in the source's plane (a box that stands
/// on the source) T has no value.
std::vector<Vec2> shadow_points(const Scene &scene, const Blockers &blockers, const Element &p, const Surface &source,
                                std::span<const PairBlocker> pair);

/// Where a blocker stands on p or goes through it, T jumps. For every such line that parts no sliver from p (narrower
/// than 0.005 of p's radius): the middles of the two parts on either side, and points close by. A fit that passes over
/// the jump fails on one side, be it the covered one: leaves must not stay large where a grid leaves only a corner of
/// them under the blocker, while other points may all lie where the fit happens to be near.
std::vector<Vec2> contact_points(const Scene &scene, const Blockers &blockers, const Element &p,
                                 std::span<const PairBlocker> pair);

} // namespace penumbra
