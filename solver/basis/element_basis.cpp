#include "basis/element_basis.h"

#include "basis/gauss.h"
#include "basis/legendre.h"

#include <array>

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

} // namespace

BasisValues ElementBasis::evaluate(const Vec2 &p) const {
    BasisValues values(n_functions());
    if (order_ == 1) {
        values[0] = 1;
        return values;
    }
    const Vec2 uv = quad_.inverse(p);
    const auto a = legendre(uv.x()), b = legendre(uv.y());
    for (int i = 0, k = 0; i < order_; ++i)
        for (int j = 0; j < order_; ++j, ++k)
            values[k] = a[static_cast<std::size_t>(i)] * b[static_cast<std::size_t>(j)];
    return values;
}

void ElementBasis::add_weighted(std::span<const Vec2> points, std::span<const double> weights,
                                std::span<double> sums) const {
    switch (order_) {
    case 1: return add<1>(quad_, points, weights, sums);
    case 2: return add<2>(quad_, points, weights, sums);
    case 3: return add<3>(quad_, points, weights, sums);
    default: return add<4>(quad_, points, weights, sums);
    }
}

QuadraturePoint ElementBasis::at_parameters(double u, double v) const {
    return {quad_.at(u, v), 1.0, quad_.jacobian(u, v)};
}

std::vector<QuadraturePoint> ElementBasis::quadrature(int n) const {
    const GaussRule &rule = gauss_rule(n);
    std::vector<QuadraturePoint> points;
    points.reserve(static_cast<std::size_t>(n) * static_cast<std::size_t>(n));
    for (std::size_t i = 0; i < rule.points.size(); ++i)
        for (std::size_t j = 0; j < rule.points.size(); ++j) {
            QuadraturePoint q = at_parameters(rule.points[i], rule.points[j]);
            const double weight = rule.weights[i] * rule.weights[j];
            q.inner *= weight;
            q.area *= weight;
            points.push_back(q);
        }
    return points;
}

} // namespace penumbra
