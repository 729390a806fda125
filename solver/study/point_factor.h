// Lambert's contour sum in space, for any polygon: a second writing of transport/lambert.h to hold solutions against.
#pragma once

#include "core/vec.h"

#include <span>

namespace penumbra {

/// Form factor from the point x with unit normal n to a simple planar polygon of any shape, all of it in front of the
/// plane at x and counter-clockwise as x sees it (Lambert 1760): -1/(2 pi) times the sum over its edges of (angle seen
/// from x) (unit r_k x r_k+1 . n). An edge whose line meets x adds nothing. Any frame and unit of length.
double point_factor(const Vec3 &x, const Vec3 &n, std::span<const Vec3> polygon);

} // namespace penumbra
