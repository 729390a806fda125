#include "basis/planar_element.h"

#include "basis/gauss.h"
#include "basis/legendre.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <limits>
#include <utility>

namespace penumbra {

namespace {

/// The box about the polygon with one side along `along`: the map from the unit square to it.
Affine box_along(const Polygon &polygon, const Vec2 &along) {
    const Vec2 across(-along.y(), along.x());
    constexpr double never = std::numeric_limits<double>::infinity();
    Vec2 low = Vec2::Constant(never), high = Vec2::Constant(-never);
    for (const Vec2 &p : polygon) {
        // From the first corner, so that what is small and far off the origin keeps its digits.
        const Vec2 d = p - polygon[0], at(d.dot(along), d.dot(across));
        low = low.cwiseMin(at);
        high = high.cwiseMax(at);
    }
    Affine box;
    box.linear.col(0) = (high.x() - low.x()) * along;
    box.linear.col(1) = (high.y() - low.y()) * across;
    box.offset = polygon[0] + low.x() * along + low.y() * across;
    return box;
}

/// The smallest box: one of its sides lies along one of the polygon's.
Affine oriented_box(const Polygon &polygon) {
    Affine best;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec2 side = polygon[(i + 1) % polygon.size()] - polygon[i];
        if (side.isZero(0))
            continue;
        const Affine box = box_along(polygon, side.normalized());
        // A little better is no better: which of two equal boxes it is must not hang on rounding.
        if (const double area = box.linear.determinant(); area < least * (1 - 1e-9)) {
            least = area;
            best = box;
        }
    }
    return best;
}

} // namespace

PlanarDomain PlanarDomain::boxed(const Polygon &polygon) {
    PlanarDomain domain;
    domain.to_parent_ = oriented_box(polygon);
    const Eigen::Matrix2d back = domain.to_parent_.linear.inverse();
    for (const Vec2 &p : polygon)
        domain.corners_.push_back(back * (p - domain.to_parent_.offset));
    domain.own_area_ = area(domain.corners_);
    return domain;
}

PlanarDomain::PlanarDomain(const Polygon &polygon) : PlanarDomain(boxed(polygon)) {
    to_plane_ = to_parent_;
    from_plane_ = to_plane_.inverse();
}

PlanarDomain PlanarDomain::part(const Polygon &polygon) const {
    PlanarDomain domain = boxed(polygon);
    domain.to_plane_ = to_plane_.after(domain.to_parent_);
    domain.from_plane_ = domain.to_parent_.inverse().after(from_plane_);
    return domain;
}

Polygon PlanarDomain::outline() const {
    Polygon outline;
    for (const Vec2 &p : corners_)
        outline.push_back(to_plane_(p));
    return outline;
}

PlanarValues legendre_products(int order, const Vec2 &own) {
    const auto a = legendre(own.x()), b = legendre(own.y());
    PlanarValues values(n_planar_functions(order));
    for (int degree = 0, k = 0; degree < order; ++degree)
        for (int j = 0; j <= degree; ++j, ++k)
            values[k] = a[static_cast<std::size_t>(degree - j)] * b[static_cast<std::size_t>(j)];
    return values;
}

PlanarElement::PlanarElement(int m, PlanarDomain where) : order(m), domain(std::move(where)) {
    const int n = n_planar_functions(order);
    coefficients = PlanarCoefficients::Identity(n, n);
    const GaussRule &rule = gauss_rule(order + 1); // products of degree 2 (order - 1), and the map's Jacobian
    for (int round = 0; round < 2; ++round) {
        Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(n, n);
        for (const Polygon &piece : quads_and_triangles(domain.corners())) {
            const BilinearQuad quad = bilinear_quad(piece);
            for (std::size_t i = 0; i < rule.points.size(); ++i)
                for (std::size_t j = 0; j < rule.points.size(); ++j) {
                    const double u = rule.points[i], v = rule.points[j];
                    const PlanarValues values = evaluate(quad.at(u, v));
                    const double weight =
                        rule.weights[i] * rule.weights[j] * quad.jacobian(u, v) / domain.own_area();
                    gram += weight * values * values.transpose();
                }
        }
        coefficients = gram.llt().matrixL().solve(coefficients).eval();
    }
    coefficients(0, 0) = 1; // but for the rounding of the area
}

} // namespace penumbra
