// Where a receiver element is looked at.
#pragma once

#include "basis/element_basis.h"

#include <vector>

namespace penumbra {

/// Projection points of an element: a tensor Gauss rule of n points a parameter, in 2 `levels` + 1 panels a parameter
/// that shrink towards both ends by 0.15 a level. Without levels it integrates products of degree 2n - 1 exactly; levels
/// are for a transfer that is singular at the border (the source touches it there: bounded, but of many values at the
/// ends of the common edge).
std::vector<QuadraturePoint> projection_points(const ElementBasis &basis, int n, int levels);

/// Points at which a fit is tested: corners, mid-sides, quarters and the centre, drawn in by 2 %; none of them a
/// projection point.
std::vector<Vec2> test_points(const ElementBasis &basis);

} // namespace penumbra
