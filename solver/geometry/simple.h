// Whether a polygon is one at all, decided exactly (CGAL).
#pragma once

#include "geometry/polygon.h"

namespace penumbra {

/// Whether no two sides of the closed polygon meet except neighbours at their common corner. False also for sides that
/// only touch, that fold back on each other, and for repeated corners.
bool is_simple(const Polygon &polygon);

} // namespace penumbra
