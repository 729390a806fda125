// The critical surface of three edges: the lines that meet all of them, one of the two families of lines on a quadric.
#pragma once

#include "discontinuity/curve.h"
#include "discontinuity/interval_set.h"
#include "discontinuity/sight_line.h"
#include "discontinuity/source_view.h"
#include "geometry/plane_frame.h"

#include <array>
#include <optional>
#include <vector>

namespace penumbra {

/// c[0] + c[1] s + c[2] s^2.
struct Quadratic {
    double c[3];

    double operator()(double s) const { return c[0] + s * (c[1] + s * c[2]); }
    /// The polar form: bilinear in s and t, equal to the value where both agree.
    double polar(double s, double t) const { return c[0] + c[1] * (s + t) / 2 + c[2] * s * t; }
    /// Adds the real roots strictly inside the interval; none for the zero polynomial.
    void add_roots(const Interval &within, std::vector<double> &roots) const;
};

/// Lines through the point P(s) = a + s (b - a) of the first edge that meet the two others. Their Plucker coordinates
/// (direction V, moment M about the first edge's a) are quadratic in s, and so is whether such a line meets another
/// one: V . (p x q) + (q - p) . M changes sign there (Plucker's side operator). The lines meet the receiver in a conic.
class Regulus {
public:
    /// None when two of the edges lie in one plane.
    static std::optional<Regulus> make(const std::array<const SightEdge *, 3> &edges, const PlaneFrame &receiver);

    /// Parameters for which the line meets the three edges in their parts that count.
    IntervalSet domain() const;
    /// On which side the line passes the line pq; zero where they meet (or are parallel).
    Quadratic side(const Vec3 &p, const Vec3 &q) const;
    /// Vanishes where the line is parallel to the receiver.
    const Quadratic &rise() const { return w_; }
    /// Vanishes where the line's foot lies in the plane; both are given by the foot's homogeneous coordinates.
    Quadratic foot_height(const PlaneFrame &plane) const;
    Vec2 foot(double s) const;
    /// From the receiver, upwards; s not where it is parallel.
    SightLine line(double s) const;
    /// The arc of the feet between two parameters without a zero of rise() between them.
    void set_arc(Curve &curve, const Interval &arc) const;

private:
    std::array<const SightEdge *, 3> edges_;
    PlaneFrame receiver_;
    Vec3 v_[3], m_[3];        ///< coefficients of V and M
    Quadratic u2_[2], u3_[2]; ///< numerator and denominator of the parameters on the second and third edge
    Quadratic x_, y_, w_;     ///< of the foot, homogeneous, in the receiver's plane
};

} // namespace penumbra
