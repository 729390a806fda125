// The seam between an element's basis and everything above it: what families have in common, and no more.
#pragma once

#include "geometry/bilinear_quad.h"

#include <Eigen/Core>

#include <span>
#include <vector>

namespace penumbra {

/// Most functions on one element: M x M for M = 4.
inline constexpr int max_functions = 16;

/// Values of all functions of an element at one point.
using BasisValues = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, max_functions, 1>;

/// A quadrature point of an element.
struct QuadraturePoint {
    Vec2 position;  ///< in the surface's plane
    double inner;   ///< weight in the basis' own inner product; the weights of a rule sum to 1
    double area;    ///< weight in dA; the weights of a rule sum to the element's area
};

/// An element's domain and the functions N_k on it. Parametric family: N_k(u,v) = L_i(u) L_j(v) with k = i M + j,
/// 0 <= i, j < M, and L the Legendre polynomials orthonormal on [0,1]: orthonormal in du dv on the unit square.
/// N_0 is the constant 1 in every family.
class ElementBasis {
public:
    ElementBasis() = default;
    ElementBasis(int order, const BilinearQuad &quad) : order_(order), quad_(quad), outline_(quad.outline()) {}

    int order() const { return order_; }
    int n_functions() const { return order_ * order_; }
    const BilinearQuad &quad() const { return quad_; }
    /// The element as a convex polygon.
    const Polygon &outline() const { return outline_; }
    double area() const { return penumbra::area(outline_); }
    Vec2 centre() const { return quad_.centre(); }

    BasisValues evaluate(const Vec2 &p) const;
    /// sums[k] += sum over the points of weight N_k(point), for k < sums.size() <= n_functions().
    void add_weighted(std::span<const Vec2> points, std::span<const double> weights, std::span<double> sums) const;
    /// Tensor Gauss rule with n points a parameter: for `inner`, exact for products of degree 2n - 1 in each parameter.
    std::vector<QuadraturePoint> quadrature(int n) const;
    /// The point of the element with these parameters in [0,1]^2, and the weights a cell there has.
    QuadraturePoint at_parameters(double u, double v) const;

private:
    int order_ = 1;
    BilinearQuad quad_;
    Polygon outline_;
};

} // namespace penumbra
