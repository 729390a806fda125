// The surface of lines of sight that throws a curve: a wedge's plane, a ruled quadric, or the plane of a polygon that
// is seen edge-on. In the scene's own frame, for drawing.
#pragma once

#include "discontinuity/curve.h"
#include "iteration/snapshot.h"
#include "scene/scene.h"

#include <vector>

namespace penumbra {

struct CriticalSurface {
    /// Lines of sight, evenly spread along the curve from its one end to the other. Each is a list of as many points:
    /// its foot on the curve, where it touches an edge or corner (near before far), and where it meets the source's
    /// plane. The surface is what is swept between neighbours. Empty for the kinds plane and contact, and where the
    /// touched edges lie in one plane with the curve: then there are as many from each of its points as there are
    /// points between.
    std::vector<std::vector<Vec3>> sights;
    /// In place of them the convex hull, in order, of the curve and of the polygon that it sees edge-on (kind plane) or
    /// of the edges in one plane.
    std::vector<Vec3> sheet;
    std::int32_t edge_on = -1; ///< of the kind plane: that polygon's surface
};

/// `n`: number of lines of sight, at least 2. A line whose direction is lost to rounding (its foot lies on what it
/// touches) is left out, and so is one that misses the source: where curves that coincide were merged, what is known to
/// be touched is so along a part of the whole only. tests/agreement checks that all others touch what they should.
CriticalSurface critical_surface(const Snapshot &snapshot, const SnapshotCurve &curve, int n);

/// The curve's touched edges in the scene's own frame, each with the surface among source and blockers that has it on
/// its outline, or else in its plane (where it was clipped).
std::vector<SnapshotEdge> touched_edges(const Scene &scene, const Curve &curve);

} // namespace penumbra
