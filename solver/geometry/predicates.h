// Exact answers to on which side; everything that decides rather than measures asks here.
#pragma once

#include "core/vec.h"

namespace penumbra {

/// Sign of ((b-a) x (c-a)) . (d-a): +1 when d lies on the side of the plane abc to which that normal points, -1 on the
/// other, 0 exactly in the plane (or when a, b, c are in line). Exact for finite doubles: CGAL,
/// Exact_predicates_inexact_constructions_kernel. Never call it on a thread that flushes denormals to zero.
int orientation(const Vec3 &a, const Vec3 &b, const Vec3 &c, const Vec3 &d);

/// Sign of (b-a) x (c-a): +1 when a, b, c turn left, 0 exactly in line.
int orientation(const Vec2 &a, const Vec2 &b, const Vec2 &c);

} // namespace penumbra
