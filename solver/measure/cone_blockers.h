// What can stand between one point and a polygon.
#pragma once

#include "visibility/visible_part.h"

#include <span>
#include <vector>

namespace penumbra {

/// The blockers that may hide something of `polygon` (convex, in the plane of `source`, whose front x sees) from x on the
/// front of `receiver`: left in `found`. Left out is what lies behind or in one of the two planes, or keeps out of the
/// cone from x to the polygon by one of its side planes. `among`: where the search may stay; null: all.
void blockers_in_cone(const Vec3 &x, const PlaneFrame &receiver, const PlaneFrame &source, std::span<const Vec2> polygon,
                      const Blockers &blockers, const std::vector<PairBlocker> *among, std::vector<PairBlocker> &found);

/// Whether all of the polygon lies behind the plane or in it.
bool behind(const PlaneFrame &plane, std::span<const Vec3> polygon);

} // namespace penumbra
