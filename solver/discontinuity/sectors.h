// What facets that meet in a point hide about it, seen along one line of sight.
#pragma once

#include "discontinuity/source_view.h"

#include <span>
#include <vector>

namespace penumbra {

/// Directions in the view about a point: from `from`, counter-clockwise by `sweep` radians.
struct Sector {
    double from, sweep;
};

/// The two rays that bound a convex facet where it touches a point, or the whole turn when the point is inside it.
struct FacetCone {
    const Facet *facet;
    bool whole;
    Vec3 first, second;
};

FacetCone cone_at(const Facet &facet, const Vec3 &point);

/// The sectors about a point that none of the cones fills, seen along `line`; facets seen edge-on fill nothing.
std::vector<Sector> free_sectors(std::span<const FacetCone> cones, const Vec3 &point, const Vec3 &line);

/// Whether the free sectors show a corner: neither nothing nor everything is hidden, nor exactly one half (a point in
/// the middle of a straight border).
bool shows_corner(std::span<const Sector> free);

/// Whether some of the cones' own sectors is free: cones of the source, free sectors left by blockers.
bool shows_any(std::span<const FacetCone> cones, const Vec3 &point, const Vec3 &line, std::span<const Sector> free);

} // namespace penumbra
