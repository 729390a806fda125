#include "transport/receiver_points.h"

#include "basis/gauss.h"

#include <array>

namespace penumbra {

std::vector<QuadraturePoint> projection_points(const ElementBasis &basis, int n, bool graded) {
    if (!graded)
        return basis.quadrature(n);
    const GaussRule &rule = gauss_rule(n);
    std::vector<double> at, weight;
    for (std::size_t i = 0; i < rule.points.size(); ++i) {
        const double s = rule.points[i], a = s * s * s, b = (1 - s) * (1 - s) * (1 - s);
        at.push_back(a / (a + b));
        weight.push_back(rule.weights[i] * 3 * s * s * (1 - s) * (1 - s) / ((a + b) * (a + b)));
    }
    std::vector<QuadraturePoint> points;
    for (std::size_t i = 0; i < at.size(); ++i)
        for (std::size_t j = 0; j < at.size(); ++j) {
            QuadraturePoint q = basis.at_parameters(at[i], at[j]);
            q.inner *= weight[i] * weight[j];
            q.area *= weight[i] * weight[j];
            points.push_back(q);
        }
    return points;
}

std::vector<Vec2> test_points(const ElementBasis &basis) {
    std::vector<Vec2> points;
    constexpr std::array<double, 5> at{0.02, 0.26, 0.5, 0.74, 0.98};
    for (std::size_t i = 0; i < at.size(); ++i)
        for (std::size_t j = 0; j < at.size(); ++j)
            if ((i + j) % 2 == 0)
                points.push_back(basis.quad().at(at[i], at[j]));
    return points;
}

} // namespace penumbra
