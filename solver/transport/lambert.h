// Lambert's closed form for the irradiance from a uniform polygon.
#pragma once

#include "core/vec.h"
#include "geometry/plane_frame.h"

#include <span>

namespace penumbra {

/// The integral of G = cos(theta_x) cos(theta_y) / (pi r^2) over a polygon (counter-clockwise in the plane of `source`,
/// whose front x sees) as received at x with unit normal n: the form factor from the point to the polygon, in [0, 1].
/// Equals 1/(2 pi) times the sum over the edges of (angle seen from x) (unit normal of the plane through x and the edge
/// . n) (Lambert 1760; Schroeder & Hanrahan 1993, eq. 1). The polygon must lie in front of the plane at x.
/// Where x is low and beside the polygon the terms cancel: the error is then that of the sum, about 1e-16.
double lambert(const Vec3 &x, const Vec3 &n, const PlaneFrame &source, std::span<const Vec2> polygon);

} // namespace penumbra
