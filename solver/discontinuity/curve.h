// A discontinuity curve on a receiver: where the irradiance from one source, or one of its derivatives, jumps.
#pragma once

#include "core/ids.h"
#include "core/vec.h"

#include <string_view>
#include <vector>

namespace penumbra {

/// What kind of critical surface throws it (Heckbert 1992; Lischinski, Tampieri & Greenberg 1992; Drettakis & Fiume
/// 1994): a vertex on the source's side and an edge on the blocker's, the reverse, three skew edges, the plane of a
/// source or of a blocker seen edge-on, or a blocker that touches or pierces the receiver.
enum class CurveKind { ve, ev, eee, plane, contact };

/// `VE`, `EV`, `EEE`, `plane`, `contact`.
std::string_view name(CurveKind kind);

/// An edge that lines of sight touch, in space; a corner has both ends in one place.
struct TouchedEdge {
    Vec3 a, b;

    bool is_corner() const { return a == b; }
};

/// A straight segment or an arc of a conic, in the receiver's plane [solver units].
struct Curve {
    CurveKind kind = CurveKind::ve;
    int order = 2; ///< the first derivative that jumps: 0 the irradiance itself, 1 its slope, 2 its curvature
    SurfaceId source;
    SurfaceId receiver;
    std::vector<SurfaceId> blockers; ///< ascending
    Vec2 from, to;                   ///< end points
    /// The middle control point of the rational quadratic Bezier curve from `from` to `to` (both of weight 1), as
    /// (weight x, weight y, weight); zero for a straight segment.
    Vec3 control = Vec3::Zero();
    /// What every line of sight from a point of the curve touches on its way to the source: corner and edge (VE, EV) or
    /// three edges (EEE); empty for the other kinds. In no particular order along the line.
    std::vector<TouchedEdge> touched{};

    bool straight() const { return control.isZero(0); }
};

/// The point at parameter t in [0, 1]; for a straight segment, too, t is not proportional to length.
Vec2 point_at(const Curve &curve, double t);

/// A polyline from `from` to `to` whose distance from the curve is at most `tolerance`; its corners lie on the curve.
std::vector<Vec2> polyline(const Curve &curve, double tolerance);

/// Distance from p to the curve; for an arc to within 1e-3 of itself or 1e-9, whichever is larger.
double distance(const Curve &curve, const Vec2 &p);

} // namespace penumbra
