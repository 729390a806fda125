// Where a receiver element is looked at.
#pragma once

#include "basis/element_basis.h"

#include <vector>

namespace penumbra {

/// Projection points of an element for a transfer that is smooth on it: a tensor Gauss rule of n points a parameter.
/// `graded`: the transfer is singular at the border (the source touches it or comes near): the same number of points,
/// crowded towards both ends of each parameter by u = s^3 / (s^3 + (1-s)^3).
std::vector<QuadraturePoint> projection_points(const ElementBasis &basis, int n, bool graded);

/// Points at which a fit is tested: corners, mid-sides, quarters and the centre, drawn in by 2 %; none of them a
/// projection point.
std::vector<Vec2> test_points(const ElementBasis &basis);

} // namespace penumbra
