#include "transport/receiver_points.h"

#include "basis/gauss.h"

#include <algorithm>
#include <array>

namespace penumbra {

namespace {

struct Rule {
    std::vector<double> at, weight;
};

/// Gauss points on [0,1], divided at `breaks` and graded towards every division.
Rule graded_rule(int n, int levels, std::vector<double> breaks) {
    breaks.insert(breaks.end(), {0.0, 1.0});
    std::ranges::sort(breaks);
    const auto same = [](double a, double b) { return b - a < 1e-9; };
    breaks.erase(std::ranges::unique(breaks, same).begin(), breaks.end());
    std::vector<double> borders;
    for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
        const double length = breaks[k + 1] - breaks[k];
        borders.push_back(breaks[k]);
        double width = 0.15;
        for (int level = 0; level < levels; ++level, width *= 0.15) {
            borders.push_back(breaks[k] + width * length);
            borders.push_back(breaks[k + 1] - width * length);
        }
    }
    borders.push_back(1);
    std::ranges::sort(borders);
    const GaussRule &gauss = gauss_rule(n);
    Rule rule;
    for (std::size_t k = 0; k + 1 < borders.size(); ++k)
        for (std::size_t i = 0; i < gauss.points.size(); ++i) {
            const double panel = borders[k + 1] - borders[k];
            rule.at.push_back(borders[k] + panel * gauss.points[i]);
            rule.weight.push_back(panel * gauss.weights[i]);
        }
    return rule;
}

} // namespace

std::vector<QuadraturePoint> projection_points(const ElementBasis &basis, int n, int levels,
                                               std::span<const Vec2> ends) {
    if (levels == 0)
        return basis.quadrature(n);
    std::vector<QuadraturePoint> points;
    const std::vector<BilinearQuad> tiles = basis.tiles();
    for (std::size_t tile = 0; tile < tiles.size(); ++tile) {
        std::vector<double> u_breaks, v_breaks;
        for (const Vec2 &end : ends) {
            const Vec2 uv = tiles[tile].inverse(end).cwiseMax(0.0).cwiseMin(1.0);
            u_breaks.push_back(uv.x());
            v_breaks.push_back(uv.y());
        }
        const Rule u = graded_rule(n, levels, std::move(u_breaks)), v = graded_rule(n, levels, std::move(v_breaks));
        for (std::size_t i = 0; i < u.at.size(); ++i)
            for (std::size_t j = 0; j < v.at.size(); ++j) {
                QuadraturePoint q = basis.at_parameters(tile, u.at[i], v.at[j]);
                q.inner *= u.weight[i] * v.weight[j];
                q.area *= u.weight[i] * v.weight[j];
                points.push_back(q);
            }
    }
    return points;
}

std::vector<Vec2> test_points(const ElementBasis &basis) {
    std::vector<Vec2> points;
    constexpr std::array<double, 7> at{0.002, 0.08, 0.26, 0.5, 0.74, 0.92, 0.998};
    for (const BilinearQuad &tile : basis.tiles())
        for (std::size_t i = 0; i < at.size(); ++i)
            for (std::size_t j = i % 2; j < at.size(); j += 2)
                points.push_back(tile.at(at[i], at[j]));
    return points;
}

} // namespace penumbra
