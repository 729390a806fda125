#include "hierarchy/push_pull.h"

#include <cmath>

namespace penumbra {

void push_pull(const Forest &forest, const Scene &scene, std::span<const ElementId> elements, const Coefficients &gathered,
               Coefficients &pushed, Coefficients &radiosity) {
    for (const ElementId id : elements) {
        const Element &e = forest[id];
        rows(e, pushed) = rows(e, gathered);
        if (e.parent.valid())
            rows(e, pushed) += e.filters->push * rows(forest[e.parent], pushed);
        rows(e, radiosity).setZero();
    }
    for (std::size_t i = elements.size(); i-- > 0;) {
        const Element &e = forest[elements[i]];
        auto b = rows(e, radiosity);
        if (e.leaf()) {
            b = rows(e, pushed) * scene.reflectance(e.surface).matrix().asDiagonal();
            b.row(0) += scene.exitance(e.surface).matrix().transpose();
        }
        if (e.parent.valid())
            rows(forest[e.parent], radiosity) += e.filters->pull * b;
    }
}

void push_pull(const Forest &forest, const Scene &scene, const Coefficients &gathered, Coefficients &radiosity) {
    Coefficients pushed(forest.n_coefficients, 3);
    radiosity.resize(forest.n_coefficients, 3);
    std::vector<ElementId> all;
    for (std::size_t e = 0; e < forest.elements.size(); ++e)
        all.emplace_back(e);
    push_pull(forest, scene, all, gathered, pushed, radiosity);
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
