// One source as one receiver may see it, past everything that could stand between: what critical surfaces are made of.
#pragma once

#include "core/ids.h"
#include "core/vec.h"
#include "discontinuity/interval_set.h"
#include "discontinuity/tolerance.h"
#include "scene/scene.h"

#include <span>
#include <vector>

namespace penumbra {

/// A convex part of a surface in space, cut to what counts: in front of the receiver and of the source.
struct Facet {
    SurfaceId surface;
    std::vector<Vec3> corners; ///< counter-clockwise about the normal
    PlaneFrame frame;          ///< of the plane through the first corner
    Vec3 centre;               ///< of the sphere about the corners
    double radius = 0;
    double bend = 0; ///< how far welding moved corners out of the first one's plane
};

/// An edge with its full end points (sides are decided with these) and the part of it that counts.
struct SightEdge {
    Vec3 a, b;
    Interval part;                   ///< of a + t (b - a), within [0, 1]
    std::vector<std::size_t> facets; ///< of the blockers, that have the edge on their border
    bool of_source = false;

    Vec3 point(double t) const { return a + t * (b - a); }
    Vec3 from() const { return point(part.low); }
    Vec3 to() const { return point(part.high); }
};

/// A corner, and the facets of blockers that it touches: those that meet there, and any on which it lies.
struct SightCorner {
    Vec3 at;
    std::vector<std::size_t> facets; ///< ascending
    bool of_source = false;
};

struct SourceView {
    SurfaceId source, receiver;
    PlaneFrame source_plane, receiver_plane;
    std::vector<Facet> source_parts;         ///< the source's convex parts in front of the receiver
    std::vector<Facet> facets;               ///< of the blockers
    std::vector<SightCorner> corners;        ///< of the source in front of the receiver, then of the blockers, ...
    std::vector<SightEdge> edges;            ///< ... and so the edges; each once, however many faces share it

    bool empty() const { return source_parts.empty(); }
};

/// Edges between two faces that no line of sight can see as a silhouette, because receiver or source lies wholly on
/// such sides of both, are left out, and so is what keeps out of the convex hull of source and receiver. Where blockers
/// pass through the source's plane, the corners and edges of the section are among theirs; what covers the source is a
/// blocker that lies on it.
///
/// Collects what `source` and `blockers` (a superset of those that may block; the two surfaces themselves and those in
/// their planes are left out) show to `receiver`. Empty when no point of the source lies in front of the receiver,
/// none of the receiver in front of the source, or one blocker hides all of the one from all of the other.
SourceView source_view(const Scene &scene, SurfaceId source, SurfaceId receiver, std::span<const SurfaceId> blockers);

/// Whether some point of each surface lies in front of the other.
bool face_each_other(const Surface &a, const Surface &b);

/// Whether the blocker hides all of the source from all of the receiver.
bool hides(const Surface &blocker, const Surface &receiver, const Surface &source);

/// Whether two ascending lists have a facet in common: then both lie in its plane, however welding bent it, and what
/// they throw together is the plane's curve.
bool share_facet(std::span<const std::size_t> a, std::span<const std::size_t> b);

/// Whether the edges lie in one plane, to within twice the `coincidence`: then they throw what that plane throws.
bool in_one_plane(const SightEdge &e, const SightEdge &f);

/// Whether p lies in the facet or on its border, to within `coincidence`.
bool touches(const Facet &facet, const Vec3 &p);

/// The convex polygon's part where (x - origin) . normal >= 0. Corners within `coincidence` of the plane count as in
/// it; empty when no corner lies truly in front.
std::vector<Vec3> clip_to_front(std::vector<Vec3> polygon, const Vec3 &origin, const Vec3 &normal);

} // namespace penumbra
