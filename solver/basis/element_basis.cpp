#include "basis/element_basis.h"

#include "basis/gauss.h"
#include "basis/legendre.h"

namespace penumbra {

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
