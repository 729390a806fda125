// Simple polygons in the plane.
#pragma once

#include "core/vec.h"

#include <span>
#include <vector>

namespace penumbra {

/// Corners in counter-clockwise order; the last joins the first.
using Polygon = std::vector<Vec2>;

/// Signed area, positive when counter-clockwise.
double area(std::span<const Vec2> polygon);
Vec2 centroid(std::span<const Vec2> polygon);
/// Half the diagonal of the bounding box.
double radius(std::span<const Vec2> polygon);
/// Whether p lies in the convex polygon or on its border, to within `slack` (a length).
bool contains(std::span<const Vec2> convex, const Vec2 &p, double slack = 0);
/// Point of the convex polygon nearest to p; the polygon may be without area.
Vec2 nearest_point(std::span<const Vec2> convex, const Vec2 &p);
/// Convex hull, counter-clockwise (Andrew's monotone chain).
Polygon convex_hull(Polygon points);
/// Convex parts of a simple counter-clockwise polygon (CGAL; as few as possible up to 32 corners); the polygon itself
/// when it is convex. No corner of a part is in line with its neighbours, even where a corner of another part lies.
std::vector<Polygon> convex_parts(const Polygon &polygon);
/// The convex polygon in pieces of at most four corners: the quads and triangles of the parametric basis.
std::vector<Polygon> quads_and_triangles(const Polygon &convex);

} // namespace penumbra
