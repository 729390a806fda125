#include "hierarchy/push_pull.h"

#include <cmath>

namespace penumbra {

namespace {

auto rows(const Element &e, auto &coefficients) { return coefficients.middleRows(e.first, e.basis.n_functions()); }

} // namespace

void push_pull(const Forest &forest, const Scene &scene, const Coefficients &gathered, Coefficients &radiosity) {
    Coefficients irradiance = gathered;
    for (const Element &e : forest.elements) // parents stand before their children
        if (e.parent.valid())
            rows(e, irradiance) += e.filters->push * rows(forest[e.parent], irradiance);

    radiosity.setZero(forest.n_coefficients, 3);
    for (std::size_t i = forest.elements.size(); i-- > 0;) {
        const Element &e = forest.elements[i];
        auto b = rows(e, radiosity);
        if (e.leaf()) {
            b = rows(e, irradiance) * scene.reflectance(e.surface).matrix().asDiagonal();
            b.row(0) += scene.exitance(e.surface).matrix().transpose();
        }
        if (e.parent.valid())
            rows(forest[e.parent], radiosity) += e.filters->pull * b;
    }
}

std::vector<double> dropped_detail(const Forest &forest, const Coefficients &radiosity) {
    std::vector<Eigen::Array3d> squares(forest.elements.size(), Eigen::Array3d::Zero());
    for (std::size_t i = forest.elements.size(); i-- > 0;) {
        const Element &e = forest.elements[i];
        if (!e.parent.valid())
            continue;
        const Element &parent = forest[e.parent];
        const Coefficients lost = rows(e, radiosity) - e.filters->push * rows(parent, radiosity);
        const double share = e.filters->pull(0, 0); // the child's part of the parent's measure
        squares[e.parent.at()] += share * (lost.array().square().colwise().sum().transpose() + squares[i]);
    }
    std::vector<double> detail(squares.size());
    for (std::size_t i = 0; i < squares.size(); ++i)
        detail[i] = std::sqrt(squares[i].maxCoeff());
    return detail;
}

} // namespace penumbra
