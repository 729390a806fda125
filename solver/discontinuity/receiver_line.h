// A line on the receiver, cut to where a curve can be.
#pragma once

#include "discontinuity/interval_set.h"
#include "discontinuity/source_view.h"
#include "scene/scene.h"

namespace penumbra {

/// The line's part inside the receiver's outline, off its covers, and in front of the source. Empty when the line runs
/// along the outline itself. `foot` and the unit vector `along` are given in space and lie in the receiver's plane.
IntervalSet lit_part(const Scene &scene, const SourceView &view, const Vec3 &foot, const Vec3 &along);

/// The interval of the line inside a convex polygon of the same plane.
Interval inside(const Polygon &convex, const Vec2 &foot, const Vec2 &along);

/// Shortest curve that is kept [solver units].
inline constexpr double shortest_curve = 1e-8;

} // namespace penumbra
