// The parametric element of the paper: x(u,v) over the unit square.
#pragma once

#include "geometry/polygon.h"

#include <algorithm>
#include <array>
#include <cmath>

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

/// The inverse of one quad's map, for many points.
class BilinearInverse {
public:
    explicit BilinearInverse(const BilinearQuad &quad);
    /// As BilinearQuad::inverse.
    Vec2 operator()(const Vec2 &p) const {
        // p - c0 = u a + v b + uv d; eliminating u leaves k0 + k1 v + k2 v^2 = 0, whose wanted root has a positive
        // derivative there (it is the Jacobian of a counter-clockwise convex quad).
        const Vec2 h = p - origin_;
        if (parallelogram_)
            return {cross(h, b_) * over_area_, cross(a_, h) * over_area_};
        const double k0 = cross(h, a_), k1 = cross(h, d_) + ab_;
        const double root = std::sqrt(std::max(0.0, k1 * k1 - 4 * k2_ * k0));
        double v = 0;
        if (k1 >= 0)
            v = k1 + root > 0 ? -2 * k0 / (k1 + root) : 0.0;
        else
            v = (root - k1) / (2 * k2_);
        const Vec2 along = a_ + v * d_;
        const double length2 = along.squaredNorm();
        return {length2 > 0 ? (h - v * b_).dot(along) / length2 : 0.5, v};
    }

private:
    Vec2 origin_, a_, b_, d_;
    double ab_, k2_, over_area_;
    bool parallelogram_; ///< to the rounding of its corners
};

/// The quad of a convex polygon of three or four corners.
BilinearQuad bilinear_quad(std::span<const Vec2> polygon);

} // namespace penumbra
