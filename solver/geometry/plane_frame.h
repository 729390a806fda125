// An orthonormal frame of a plane; elements and clipping work in its two coordinates.
#pragma once

#include "core/vec.h"

#include <span>

namespace penumbra {

struct PlaneFrame {
    Vec3 origin = Vec3::Zero();
    Vec3 u = Vec3::UnitX(), v = Vec3::UnitY(); ///< unit, orthogonal, in the plane
    Vec3 normal = Vec3::UnitZ();               ///< u x v, the front side

    Vec3 to_space(const Vec2 &p) const { return origin + p.x() * u + p.y() * v; }
    Vec2 to_plane(const Vec3 &x) const { return {(x - origin).dot(u), (x - origin).dot(v)}; }
    /// Signed distance of x from the plane, positive in front.
    double height(const Vec3 &x) const { return (x - origin).dot(normal); }
};

/// Frame of a planar polygon: normal by Newell's sum (counter-clockwise seen from the front), u along the longest edge,
/// origin at the first vertex. The polygon must have area.
PlaneFrame plane_frame(std::span<const Vec3> polygon);

/// Sum of cross products of consecutive vertices (Newell): normal direction times twice the area.
Vec3 newell(std::span<const Vec3> polygon);

} // namespace penumbra
