// The seam between an element's basis and everything above it: what families have in common, and no more.
#pragma once

#include "basis/planar_element.h"
#include "geometry/bilinear_quad.h"

#include <Eigen/Core>

#include <span>
#include <variant>
#include <vector>

namespace penumbra {

/// Most functions on one element: M x M for M = 4.
inline constexpr int max_functions = 16;

/// Values of all functions of an element at one point.
using BasisValues = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, max_functions, 1>;

/// A quadrature point of an element.
struct QuadraturePoint {
    Vec2 position;  ///< in the surface's plane
    Vec2 own;       ///< in the element's own coordinates: its parameters, or its box' unit square
    double inner;   ///< weight in the basis' own inner product; the weights of a rule sum to 1
    double area;    ///< weight in dA; the weights of a rule sum to the element's area
};

/// An element's domain and the functions N_k on it, of one of two families; N_0 is the constant 1 in both.
/// Parametric (Bouatouch & Pattanaik 1995): on a bilinear quad, N_k(u,v) = L_i(u) L_j(v) with k = i M + j, 0 <= i, j < M,
/// and L the Legendre polynomials orthonormal on [0,1]: orthonormal in du dv on the unit square.
/// Planar: on any convex polygon, polynomials of the plane of total degree < M, orthonormal in dA/|A|
/// (planar_element.h).
class ElementBasis {
public:
    ElementBasis() : domain_(BilinearQuad{{Vec2::Zero(), Vec2::Zero(), Vec2::Zero(), Vec2::Zero()}}) {}
    ElementBasis(int order, const BilinearQuad &quad) : order_(order), domain_(quad), outline_(quad.outline()) {}
    ElementBasis(int order, PlanarDomain domain);

    int order() const { return order_; }
    int n_functions() const { return n_functions(order_); }
    /// Of the same family and a lower order m: how many, and where its k-th one stands among the element's.
    int n_functions(int m) const { return planar() ? n_planar_functions(m) : m * m; }
    int place(int m, int k) const { return planar() ? k : k / m * order_ + k % m; }
    /// Null for the other family.
    const BilinearQuad *quad() const { return std::get_if<BilinearQuad>(&domain_); }
    const PlanarElement *planar() const { return std::get_if<PlanarElement>(&domain_); }
    /// The element as a convex polygon.
    const Polygon &outline() const { return outline_; }
    double area() const { return penumbra::area(outline_); }
    Vec2 centre() const { return quad() ? quad()->centre() : centroid(outline_); }

    BasisValues evaluate(const Vec2 &p) const;
    /// The same in the element's own coordinates: faster, and to rounding in slivers too.
    BasisValues evaluate(const QuadraturePoint &q) const;
    /// sums[k] += sum over the points of weight N_k(point), for k < sums.size() <= n_functions().
    void add_weighted(std::span<const Vec2> points, std::span<const double> weights, std::span<double> sums) const;

    /// Quads and triangles that tile the element, in the plane: one, but for polygons of more than four corners.
    std::vector<BilinearQuad> tiles() const;
    std::size_t n_tiles() const { return quad() ? 1 : own_tiles_.size(); }
    /// The point of a tile with these parameters in [0,1]^2, and the weights that the tile's parameter square has there.
    QuadraturePoint at_parameters(std::size_t tile, double u, double v) const;
    /// Tensor Gauss rule with n points a parameter of each tile: for `inner`, exact for products of degree 2n - 1 in each
    /// parameter (parametric), or of total degree 2n - 2 (planar).
    std::vector<QuadraturePoint> quadrature(int n) const;

    /// The same functions as another one may evaluate them: products L_i(s) L_j(t) of the parameters (s, t) of a quad,
    /// the element's own or its box. Coefficients (functions x channels) become those of the products, i * order + j.
    BilinearQuad product_quad() const;
    Eigen::MatrixX3d product_coefficients(const Eigen::MatrixX3d &coefficients) const;

private:
    int order_ = 1;
    std::variant<BilinearQuad, PlanarElement> domain_;
    Polygon outline_;
    std::vector<BilinearQuad> own_tiles_; ///< planar: in its own frame
};

} // namespace penumbra
