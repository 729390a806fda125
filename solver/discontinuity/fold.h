// Edges between two facets that no line of sight sees as a silhouette.
#pragma once

#include "discontinuity/source_view.h"

#include <array>
#include <optional>
#include <span>

namespace penumbra {

/// An edge that exactly two facets of blockers share. Lines of sight that touch it pass from the one side of each
/// facet's plane to the other; from sides of which one is inside the angle between the facets, one of them hides what
/// the other leaves open, and the edge bounds nothing.
class Fold {
public:
    static std::optional<Fold> make(const SightEdge &edge, std::span<const Facet> facets);

    /// Whether all the points lie clearly on such sides: then the edge is a fold for every line of sight that begins or
    /// ends in their convex hull.
    bool hides_from(std::span<const Vec3> points) const;

private:
    Vec3 at_;
    std::array<Vec3, 2> normals_; ///< unit, of the facets' planes, each with its facet's inside to the left of the edge
};

} // namespace penumbra
