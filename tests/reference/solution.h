// One solution beside another, point by point.
#pragma once

#include "iteration/state.h"

namespace penumbra::reference {

/// Radiosity [W/m2] of a state at a point of a surface's plane, from the leaf that holds it; dark outside.
Rgb radiosity_at(const State &state, SurfaceId surface, const Vec2 &p);

/// Root mean square over all reflecting surfaces and channels [W/m2], at 48 x 48 points of each root element weighed by
/// area; covered points are left out.
double root_mean_square_difference(const Scene &scene, const State &a, const State &b);

/// Of B - E alone, to relate a difference to.
double root_mean_square_reflected(const Scene &scene, const State &a);

} // namespace penumbra::reference
