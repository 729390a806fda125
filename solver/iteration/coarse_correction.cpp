#include "iteration/coarse_correction.h"

#include <Eigen/LU>

#include <algorithm>

namespace penumbra {

namespace {

double area(const Forest &forest, SurfaceId s) {
    double sum = 0;
    for (const ElementId root : forest.roots[s.at()])
        sum += forest[root].basis.area();
    return sum;
}

/// F_st, from all links at whatever level: of constants, N_0's coefficient is all there is.
Eigen::MatrixXd form_factors(const State &state, int n_surfaces) {
    Eigen::MatrixXd factors = Eigen::MatrixXd::Zero(n_surfaces, n_surfaces);
    for (const auto &here : state.interactions)
        for (const auto &interaction : here) {
            const Element &p = state.forest[interaction->receiver];
            for (const Link &link : interaction->links)
                factors(p.surface.index, interaction->source.index) += p.basis.area() * link.kernel(0, 0);
        }
    for (int s = 0; s < n_surfaces; ++s) {
        factors.row(s) /= area(state.forest, SurfaceId(s));
        factors.row(s) /= std::max(1.0, factors.row(s).sum());
    }
    return factors;
}

} // namespace

bool corrects_coarsely(const Setting &setting) {
    switch (setting.options.coarse_correction) {
    case Switch::on:
        return true;
    case Switch::off:
        return false;
    case Switch::automatic:
        break;
    }
    return setting.largest_reflectance() >= 0.95;
}

void correct_coarsely(const Setting &setting, State &state, const Coefficients &before) {
    const Scene &scene = *setting.scene;
    const int n = scene.n_surfaces();
    Eigen::Matrix<double, Eigen::Dynamic, 3> change = Eigen::Matrix<double, Eigen::Dynamic, 3>::Zero(n, 3);
    for (int s = 0; s < n; ++s) {
        const SurfaceId id(s);
        for (const ElementId root : state.forest.roots[id.at()]) {
            const Element &e = state.forest[root];
            change.row(s) += e.basis.area() * (state.radiosity.row(e.first) - before.row(e.first));
        }
        change.row(s) /= area(state.forest, id);
    }
    const Eigen::Matrix<double, Eigen::Dynamic, 3> to_come =
        bounces_to_come(setting, state, change, setting.options.gather == GatherOrder::gauss_seidel);
    for (const Element &e : state.forest.elements)
        state.radiosity.row(e.first) += to_come.row(e.surface.index);
}

Eigen::Matrix<double, Eigen::Dynamic, 3> bounces_to_come(const Setting &setting, const State &state,
                                                         const Eigen::Matrix<double, Eigen::Dynamic, 3> &mean,
                                                         bool from_later_alone) {
    const Scene &scene = *setting.scene;
    const int n = scene.n_surfaces();
    const Eigen::MatrixXd factors = form_factors(state, n);
    Eigen::Matrix<double, Eigen::Dynamic, 3> out (n, 3);
    for (int channel = 0; channel < 3; ++channel) {
        Eigen::VectorXd rho(n);
        for (int s = 0; s < n; ++s)
            rho[s] = scene.reflectance(SurfaceId(s))[channel];
        const Eigen::MatrixXd a = rho.asDiagonal() * factors;
        const Eigen::VectorXd first = from_later_alone ? Eigen::VectorXd(a.triangularView<Eigen::StrictlyUpper>() * mean.col(channel))
                                                       : Eigen::VectorXd(a * mean.col(channel));
        out.col(channel) = (Eigen::MatrixXd::Identity(n, n) - a).partialPivLu().solve(first);
    }
    return out;
}

} // namespace penumbra
