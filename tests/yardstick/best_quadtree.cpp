#include "yardstick/best_quadtree.h"

#include "basis/two_scale.h"
#include "core/parallel.h"

#include <algorithm>
#include <cmath>
#include <queue>

namespace penumbra::yardstick {

namespace {

struct Cell {
    BilinearQuad quad;
    int first_child = -1;
    double error = 0; ///< squared, of the best fit
    double whole = 0; ///< square of the light itself
};

void fit(const ExactLight &exact, int order, int n, Cell &cell) {
    const ElementBasis basis(order, cell.quad);
    const std::vector<Sample> samples = exact.samples(basis.outline(), n);
    std::vector<BasisValues> values;
    // On a parallelogram functions orthonormal in the parameters are orthonormal in dA / area.
    Eigen::Matrix<double, Eigen::Dynamic, 3> coefficients =
        Eigen::Matrix<double, Eigen::Dynamic, 3>::Zero(basis.n_functions(), 3);
    for (const Sample &s : samples) {
        values.push_back(basis.evaluate(s.position));
        coefficients += s.area / basis.area() * values.back() * s.value.matrix().transpose();
    }
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const Rgb fitted = (values[i].transpose() * coefficients).transpose().array();
        cell.error += samples[i].area * (fitted - samples[i].value).square().sum();
        cell.whole += samples[i].area * samples[i].value.square().sum();
    }
}

} // namespace

std::vector<Standing> best_quadtree(const ExactLight &exact, const BilinearQuad &root, int order, double target,
                                    int n) {
    std::vector<Cell> cells{{root}};
    fit(exact, order, n, cells[0]);
    const double allowed = target * target * cells[0].whole;

    // A cell is split before all cells of less error, whatever else is split: so many can be at once, down to a floor.
    for (double floor = allowed;; floor /= 4) {
        for (std::vector<std::size_t> above;; above.clear()) {
            for (std::size_t c = 0; c < cells.size(); ++c)
                if (cells[c].first_child < 0 && cells[c].error > floor)
                    above.push_back(c);
            if (above.empty())
                break;
            const std::size_t first = cells.size();
            for (const std::size_t c : above) {
                cells[c].first_child = static_cast<int>(cells.size());
                for (const BilinearQuad &quad : uniform_children(BilinearQuad(cells[c].quad)))
                    cells.push_back({quad});
            }
            parallel_for(cells.size() - first, [&](std::size_t i) { fit(exact, order, n, cells[first + i]); });
        }
        double left = 0;
        for (const Cell &c : cells)
            left += c.first_child < 0 ? c.error : 0;
        if (left <= allowed)
            break;
    }

    const auto less = [&](std::size_t a, std::size_t b) { return cells[a].error < cells[b].error; };
    std::priority_queue<std::size_t, std::vector<std::size_t>, decltype(less)> leaves(less);
    leaves.push(0);
    double left = cells[0].error;
    std::vector<Standing> out{{1, std::sqrt(left / cells[0].whole)}};
    while (left > allowed && cells[leaves.top()].first_child >= 0) {
        const Cell &worst = cells[leaves.top()];
        leaves.pop();
        left -= worst.error;
        for (int c = 0; c < 4; ++c) {
            leaves.push(static_cast<std::size_t>(worst.first_child + c));
            left += cells[static_cast<std::size_t>(worst.first_child + c)].error;
        }
        out.push_back({out.back().patches + 3, std::sqrt(std::max(0.0, left) / cells[0].whole)});
    }
    return out;
}

int patches_for(const std::vector<Standing> &standings, double error) {
    const auto found = std::ranges::find_if(standings, [&](const Standing &s) { return s.error <= error; });
    return found == standings.end() ? 0 : found->patches;
}

} // namespace penumbra::yardstick
