// Which curves lie between two points of a receiver.
#pragma once

#include "iteration/snapshot.h"

#include <vector>

namespace penumbra {

/// Of snapshot.curves those on the surface that the segment crosses (points in the scene's own frame), in its order.
std::vector<int> crossed_curves(const Snapshot &snapshot, int surface, const Vec3 &from, const Vec3 &to);

} // namespace penumbra
