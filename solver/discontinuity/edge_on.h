// Sight within one plane: what a line of points sees of the source through a plane that holds their lines of sight.
#pragma once

#include "discontinuity/interval_set.h"
#include "discontinuity/source_view.h"
#include "discontinuity/wedge.h"

#include <optional>
#include <span>
#include <vector>

namespace penumbra {

/// The plane of a facet, as sides and lines are asked of it; none when it does not cross the receiver's plane.
std::optional<Wedge> plane_of(const Facet &facet, const PlaneFrame &receiver);

/// Convex figures of the plane, segments among them, as points (parameter on the receiver's line, height over it).
struct EdgeOnScene {
    std::vector<Polygon> targets;  ///< the source, where it meets the plane
    std::vector<Polygon> masks;    ///< one of them must stand before the target; none given: nothing must
    std::vector<Polygon> blockers; ///< none of them may
};

/// What of the view, and of these facets of it, lies in the plane: facets that cross it, or border on it in one edge from
/// both sides. With `front` +1 or -1, those that border on it from that side block too.
EdgeOnScene edge_on_scene(const SourceView &view, std::span<const std::size_t> facets, const Wedge &plane,
                          int front = 0);

/// The polygon in the plane's two coordinates.
Polygon flattened(const Wedge &plane, const std::vector<Vec3> &corners);

/// Distance along the ray, in units of the direction, at which it first meets one of the figures; infinite when it does
/// not.
double first_hit(std::span<const Polygon> figures, const Vec2 &origin, const Vec2 &direction);

/// Cuts the line where its points see the order of the given points change.
void split_between(std::span<const Vec2> points, IntervalSet &line);

/// Directions from x between neighbouring points as seen from there, up to half a turn.
std::vector<Vec2> directions_between(std::span<const Vec2> points, const Vec2 &x);

std::vector<Vec2> points_of(const EdgeOnScene &scene);

/// Points of `line` from which some sight line in the plane passes a mask and reaches a target.
IntervalSet edge_on_sight(const EdgeOnScene &scene, IntervalSet line);

} // namespace penumbra
