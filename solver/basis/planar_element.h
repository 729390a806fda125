// The planar family: convex polygons of any shape, with polynomials of the plane that are orthonormal over them.
#pragma once

#include "geometry/bilinear_quad.h"

#include <Eigen/Core>

#include <vector>

namespace penumbra {

/// p -> linear p + offset.
struct Affine {
    Eigen::Matrix2d linear = Eigen::Matrix2d::Identity();
    Vec2 offset = Vec2::Zero();

    Vec2 operator()(const Vec2 &p) const { return linear * p + offset; }
    /// This map after the other.
    Affine after(const Affine &o) const { return {linear * o.linear, linear * o.offset + offset}; }
    Affine inverse() const {
        const Eigen::Matrix2d back = linear.inverse();
        return {back, -back * offset};
    }
};

/// A convex polygon in a frame of its own, in which its oriented bounding box is the unit square; each side of the box
/// is scaled for itself, so that a sliver is as well conditioned as a square. Frames are chained from parent to child
/// and never go through the plane: in plane coordinates a sliver of aspect 1e6 loses half of its digits.
class PlanarDomain {
public:
    PlanarDomain() = default;
    /// Of a polygon in the plane.
    explicit PlanarDomain(const Polygon &polygon);
    /// Of a polygon in this domain's frame.
    PlanarDomain part(const Polygon &polygon) const;

    const Polygon &corners() const { return corners_; } ///< in its own frame, counter-clockwise
    Polygon outline() const;                            ///< in the plane
    const Affine &to_parent() const { return to_parent_; }
    const Affine &to_plane() const { return to_plane_; }
    Vec2 from_plane(const Vec2 &p) const { return from_plane_(p); }
    double own_area() const { return own_area_; }
    /// |part| / |whole|, for a part made by part().
    double share_of_parent(const PlanarDomain &parent) const {
        return own_area_ * to_parent_.linear.determinant() / parent.own_area_;
    }

private:
    static PlanarDomain boxed(const Polygon &polygon);

    Polygon corners_;
    Affine to_parent_, to_plane_, from_plane_;
    double own_area_ = 0;
};

/// Number of polynomials of the plane of total degree < order.
constexpr int n_planar_functions(int order) { return order * (order + 1) / 2; }

using PlanarValues = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 10, 1>;
using PlanarCoefficients = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 10, 10>;

/// Values of L_i(x) L_j(y), i + j < order, by degree i + j and then by j.
PlanarValues legendre_products(int order, const Vec2 &own);

/// Polynomials N_k = sum over l of C_kl times the l-th Legendre product in the domain's frame, C lower triangular,
/// orthonormal over the polygon in dA/|A|; N_0 = 1.
struct PlanarElement {
    /// Orthonormalises twice (Cholesky): to rounding also where the first Gram matrix is badly conditioned.
    PlanarElement(int order, PlanarDomain where);

    PlanarValues evaluate(const Vec2 &own) const { return coefficients * legendre_products(order, own); }

    int order;
    PlanarDomain domain;
    PlanarCoefficients coefficients;
};

} // namespace penumbra
