// The critical surface of a corner and an edge: the plane through both, cut with the receiver's plane.
#pragma once

#include "core/vec.h"
#include "discontinuity/interval_set.h"
#include "discontinuity/tolerance.h"
#include "geometry/plane_frame.h"

#include <optional>

namespace penumbra {

/// Lines of sight through `apex` meet the receiver in the line foot + s along. A point q of the plane below the apex'
/// height is seen in front of the apex' far side, one above it through the apex; both have one s.
struct Wedge {
    Vec3 apex, a, b; ///< the corner, and two points of the edge
    Vec3 normal;     ///< unit, along (a - apex) x (b - apex)
    PlaneFrame receiver;
    double apex_height = 0;     ///< over the receiver, positive
    Vec3 foot, along;           ///< unit
    double slack = coincidence; ///< what lies nearer to the plane is in it

    /// +1, 0 or -1: where q lies, 0 within the slack, the sign exact otherwise.
    int side(const Vec3 &q) const;
    double height(const Vec3 &q) const { return (q - apex).dot(normal); }
    Vec3 on_receiver(double s) const { return foot + s * along; }
    /// Where the line of sight through the apex and q meets the receiver; very far when q is as high as the apex.
    double parameter(const Vec3 &q) const;
    /// The interval of sight lines that meet the segment pq of the plane between receiver and apex ...
    Interval below(const Vec3 &p, const Vec3 &q) const;
    /// ... or farther than the apex.
    Interval above(const Vec3 &p, const Vec3 &q) const;
};

/// None when the corner lies on the edge's line, or the plane does not cross the receiver's, or the apex is not in
/// front.
std::optional<Wedge> make_wedge(const Vec3 &apex, const Vec3 &a, const Vec3 &b, const PlaneFrame &receiver);

} // namespace penumbra
