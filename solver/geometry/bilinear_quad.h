// The parametric element of the paper: x(u,v) over the unit square.
#pragma once

#include "geometry/polygon.h"

#include <array>

namespace penumbra {

/// x(u,v) = (1-u)(1-v) c0 + u(1-v) c1 + uv c2 + (1-u)v c3, corners counter-clockwise and convex. Two neighbouring corners
/// coincide in a triangle, whose Jacobian vanishes there; Gauss points never touch that corner.
struct BilinearQuad {
    std::array<Vec2, 4> corners;

    Vec2 at(double u, double v) const;
    /// |dx/du x dx/dv|: area in the plane per area of the parameter square.
    double jacobian(double u, double v) const;
    /// (u,v) of a point of the quad, to rounding; beyond the quad the map is continued, as far as it has an inverse.
    Vec2 inverse(const Vec2 &p) const;
    double area() const { return penumbra::area(corners); }
    Vec2 centre() const { return at(0.5, 0.5); }
    /// The corners without repetition: four or three.
    Polygon outline() const;
};

/// The quad of a convex polygon of three or four corners.
BilinearQuad bilinear_quad(std::span<const Vec2> polygon);

} // namespace penumbra
