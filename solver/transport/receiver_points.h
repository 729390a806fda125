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

/// Points at which a fit is tested, 25 on each tile, none of them a projection point: every second one of a 7 x 7 grid
/// that is denser towards the border and drawn in by 0.2 %. What a polynomial of order M misses is nearly one of degree
/// M, largest at the corners and falling there by a third within 2 %.
std::vector<Vec2> test_points(const ElementBasis &basis);

} // namespace penumbra
