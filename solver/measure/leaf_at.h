// The element that holds a point of its surface.
#pragma once

#include "hierarchy/forest.h"
#include "hierarchy/push_pull.h"

namespace penumbra {

/// The leaf of the surface that holds `point` (in its plane), down the tree; where rounding leaves the point outside every
/// element, the one that it is least outside of. On a common side, any of the two.
ElementId leaf_at(const Forest &forest, SurfaceId surface, const Vec2 &point);

/// B_h at that point [W/m2].
Rgb radiosity_at(const Forest &forest, const Coefficients &radiosity, SurfaceId surface, const Vec2 &point);

} // namespace penumbra
