// Quadrature rules for G over a convex piece of a source, seen from one point.
#pragma once

#include "geometry/bilinear_quad.h"
#include "geometry/plane_frame.h"

#include <algorithm>
#include <numbers>
#include <span>
#include <vector>

namespace penumbra {

/// Points of a source with their quadrature weights times G.
struct WeightedPoints {
    std::vector<Vec2> points;
    std::vector<double> weights;

    void clear() {
        points.clear();
        weights.clear();
    }
    void add(const Vec2 &p, double weight) {
        points.push_back(p);
        weights.push_back(weight);
    }
};

/// A receiver point x with its unit normal n, as the source's plane sees it.
struct Eye {
    const Vec3 &n;
    const PlaneFrame &source;
    Vec3 base;     ///< the frame's origin as seen from x
    double height; ///< of x above the source's plane
    Vec2 foot;     ///< of x in the source's plane

    Eye(const Vec3 &x, const Vec3 &normal, const PlaneFrame &frame)
        : n(normal), source(frame), base(frame.origin - x), height(frame.height(x)), foot(frame.to_plane(x)) {}

    Vec2 n_plane() const { return {n.dot(source.u), n.dot(source.v)}; }
    /// n . (y - x).
    double facing(const Vec2 &p) const { return n.dot(base + p.x() * source.u + p.y() * source.v); }
    double distance(const Vec2 &p) const { return std::hypot(height, (p - foot).norm()); }
    /// G where n . (y - x) and |y - x|^2 are known.
    double kernel(double facing, double r2) const {
        return std::max(0.0, facing) * height / (std::numbers::pi * r2 * r2);
    }
};

/// Tensor Gauss rule of n points a parameter, in quads that share the piece's first corner. Converges as rho^(-2n),
/// with log(rho) = asinh(distance / radius).
void add_far(const Eye &eye, std::span<const Vec2> piece, int n, WeightedPoints &out);

/// The triangles between y*, the point of the piece nearest to x, and the piece's edges, in polar coordinates about y*,
/// both directions graded by sinh: panels of n points converge as 2.5^(-2n) however near x is.
void add_near(const Eye &eye, std::span<const Vec2> piece, const Vec2 &nearest, double distance, int n,
              WeightedPoints &out);

/// The same along rays from the double corner of a triangle (corners[2] = corners[3], or any other two neighbours):
/// functions of a direction about that corner are smooth along and across the rays, and about no other point. Both
/// directions are graded towards where they come nearest to x.
void add_fan(const Eye &eye, std::span<const Vec2> piece, const BilinearQuad &triangle, int n, WeightedPoints &out);

} // namespace penumbra
