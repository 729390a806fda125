#include "basis/element_basis.h"

#include "basis/gauss.h"
#include "basis/legendre.h"

#include <array>
#include <utility>

namespace penumbra {

namespace {

/// The order is known to the compiler, so that the sums stay in registers.
template <std::size_t M>
void add(const BilinearQuad &quad, std::span<const Vec2> points, std::span<const double> weights, std::span<double> sums) {
    const BilinearInverse parameters(quad);
    std::array<double, M * M> sum{};
    for (std::size_t p = 0; p < points.size(); ++p) {
        const Vec2 uv = parameters(points[p]);
        const auto a = legendre(uv.x()), b = legendre(uv.y());
        for (std::size_t i = 0; i < M; ++i) {
            const double weighted = weights[p] * a[i];
            for (std::size_t j = 0; j < M; ++j)
                sum[i * M + j] += weighted * b[j];
        }
    }
    for (std::size_t k = 0; k < sums.size(); ++k)
        sums[k] += sum[k];
}

template <std::size_t M>
void add(const PlanarElement &element, std::span<const Vec2> points, std::span<const double> weights, std::span<double> sums) {
    constexpr std::size_t n = M * (M + 1) / 2;
    std::array<double, n> sum{};
    for (std::size_t p = 0; p < points.size(); ++p) {
        const Vec2 own = element.domain.from_plane(points[p]);
        const auto a = legendre(own.x()), b = legendre(own.y());
        for (std::size_t degree = 0, k = 0; degree < M; ++degree)
            for (std::size_t j = 0; j <= degree; ++j, ++k)
                sum[k] += weights[p] * a[degree - j] * b[j];
    }
    for (std::size_t k = 0; k < sums.size(); ++k)
        for (std::size_t l = 0; l <= k; ++l)
            sums[k] += element.coefficients(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(l)) * sum[l];
}

template <class Domain>
void add(int order, const Domain &domain, std::span<const Vec2> points, std::span<const double> weights,
         std::span<double> sums) {
    switch (order) {
    case 1: return add<1>(domain, points, weights, sums);
    case 2: return add<2>(domain, points, weights, sums);
    case 3: return add<3>(domain, points, weights, sums);
    default: return add<4>(domain, points, weights, sums);
    }
}

BasisValues products(int order, const Vec2 &uv) {
    BasisValues values(order * order);
    const auto a = legendre(uv.x()), b = legendre(uv.y());
    for (int i = 0, k = 0; i < order; ++i)
        for (int j = 0; j < order; ++j, ++k)
            values[k] = a[static_cast<std::size_t>(i)] * b[static_cast<std::size_t>(j)];
    return values;
}

} // namespace

ElementBasis::ElementBasis(int order, PlanarDomain domain)
    : order_(order), domain_(PlanarElement(order, std::move(domain))), outline_(planar()->domain.outline()) {
    for (const Polygon &piece : quads_and_triangles(planar()->domain.corners()))
        own_tiles_.push_back(bilinear_quad(piece));
}

BasisValues ElementBasis::evaluate(const Vec2 &p) const {
    if (order_ == 1)
        return BasisValues::Ones(1);
    return quad() ? products(order_, quad()->inverse(p)) : BasisValues(planar()->evaluate(planar()->domain.from_plane(p)));
}

BasisValues ElementBasis::evaluate(const QuadraturePoint &q) const {
    return quad() ? products(order_, q.own) : BasisValues(planar()->evaluate(q.own));
}

void ElementBasis::add_weighted(std::span<const Vec2> points, std::span<const double> weights,
                                std::span<double> sums) const {
    std::visit([&](const auto &domain) { add(order_, domain, points, weights, sums); }, domain_);
}

std::vector<BilinearQuad> ElementBasis::tiles() const {
    if (quad())
        return {*quad()};
    std::vector<BilinearQuad> tiles = own_tiles_;
    for (BilinearQuad &tile : tiles)
        for (Vec2 &corner : tile.corners)
            corner = planar()->domain.to_plane()(corner);
    return tiles;
}

QuadraturePoint ElementBasis::at_parameters(std::size_t tile, double u, double v) const {
    if (quad())
        return {quad()->at(u, v), {u, v}, 1.0, quad()->jacobian(u, v)};
    const PlanarDomain &domain = planar()->domain;
    const Vec2 own = own_tiles_[tile].at(u, v);
    const double own_area = own_tiles_[tile].jacobian(u, v);
    return {domain.to_plane()(own), own, own_area / domain.own_area(), own_area * domain.to_plane().linear.determinant()};
}

std::vector<QuadraturePoint> ElementBasis::quadrature(int n) const {
    const GaussRule &rule = gauss_rule(n);
    std::vector<QuadraturePoint> points;
    points.reserve(n_tiles() * rule.points.size() * rule.points.size());
    for (std::size_t tile = 0; tile < n_tiles(); ++tile)
        for (std::size_t i = 0; i < rule.points.size(); ++i)
            for (std::size_t j = 0; j < rule.points.size(); ++j) {
                QuadraturePoint q = at_parameters(tile, rule.points[i], rule.points[j]);
                const double weight = rule.weights[i] * rule.weights[j];
                q.inner *= weight;
                q.area *= weight;
                points.push_back(q);
            }
    return points;
}

BilinearQuad ElementBasis::product_quad() const {
    if (quad())
        return *quad();
    const Affine &box = planar()->domain.to_plane();
    return {{box({0, 0}), box({1, 0}), box({1, 1}), box({0, 1})}};
}

Eigen::MatrixX3d ElementBasis::product_coefficients(const Eigen::MatrixX3d &coefficients) const {
    if (quad())
        return coefficients;
    const Eigen::MatrixX3d by_degree = planar()->coefficients.transpose() * coefficients;
    Eigen::MatrixX3d products = Eigen::MatrixX3d::Zero(order_ * order_, 3);
    for (int degree = 0, k = 0; degree < order_; ++degree)
        for (int j = 0; j <= degree; ++j, ++k)
            products.row((degree - j) * order_ + j) = by_degree.row(k);
    return products;
}

} // namespace penumbra
