#include "iteration/link_fit.h"

namespace penumbra {

LinkFit::LinkFit(const Forest &forest, const Interaction &interaction, const Coefficients &radiosity)
    : basis_(forest[interaction.receiver].basis), order_(interaction.order),
      coefficients_(Eigen::MatrixX3d::Zero(basis_.n_functions(order_), 3)) {
    for (const Link &link : interaction.links)
        coefficients_ += link.kernel * radiosity.middleRows(forest[link.source].first, link.kernel.cols());
}

Rgb LinkFit::at(const Vec2 &point) const {
    const BasisValues all = basis_.evaluate(point);
    Rgb sum = Rgb::Zero();
    for (int k = 0; k < coefficients_.rows(); ++k)
        sum += all[basis_.place(order_, k)] * coefficients_.row(k).transpose().array();
    return sum;
}

} // namespace penumbra
