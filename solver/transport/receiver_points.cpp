#include "transport/receiver_points.h"

#include "basis/gauss.h"

#include <algorithm>
#include <array>

namespace penumbra {

std::vector<QuadraturePoint> projection_points(const ElementBasis &basis, int n, int levels) {
    if (levels == 0)
        return basis.quadrature(n);
    std::vector<double> borders{0, 1};
    double width = 0.15;
    for (int level = 0; level < levels; ++level, width *= 0.15) {
        borders.push_back(width);
        borders.push_back(1 - width);
    }
    std::ranges::sort(borders);
    const GaussRule &rule = gauss_rule(n);
    std::vector<double> at, weight;
    for (std::size_t k = 0; k + 1 < borders.size(); ++k)
        for (std::size_t i = 0; i < rule.points.size(); ++i) {
            const double panel = borders[k + 1] - borders[k];
            at.push_back(borders[k] + panel * rule.points[i]);
            weight.push_back(panel * rule.weights[i]);
        }
    std::vector<QuadraturePoint> points;
    points.reserve(at.size() * at.size());
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
