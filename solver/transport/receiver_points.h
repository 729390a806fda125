// Where a receiver element is looked at.
#pragma once

#include "basis/element_basis.h"

#include <span>
#include <vector>

namespace penumbra {

/// Projection points of an element: a tensor Gauss rule of n points a parameter. Without `levels` it integrates products
/// of degree 2n - 1 exactly. Levels are for a transfer that is singular where the source touches the element (bounded,
/// but of many values at the ends of the common edge): each parameter is divided at the parameters of `ends`, and each
/// part into 2 `levels` + 1 panels that shrink towards both its ends by 0.15 a level.
std::vector<QuadraturePoint> projection_points(const ElementBasis &basis, int n, int levels = 0,
                                               std::span<const Vec2> ends = {});

/// Points at which a fit is tested: corners, mid-sides, quarters and the centre, drawn in by 2 %; none of them a
/// projection point.
std::vector<Vec2> test_points(const ElementBasis &basis);

} // namespace penumbra
