#include "basis/two_scale.h"

namespace penumbra {

TwoScale two_scale(const ElementBasis &parent, const ElementBasis &child, int n) {
    TwoScale filters{Eigen::MatrixXd::Zero(child.n_functions(), parent.n_functions()),
                     Eigen::MatrixXd::Zero(parent.n_functions(), child.n_functions())};
    for (const QuadraturePoint &q : child.quadrature(n)) {
        const BasisValues above = parent.evaluate(q.position), below = child.evaluate(q.position);
        filters.push += q.inner * below * above.transpose();
        // A(u',v') of (7): parameter area of the parent per parameter area of the child.
        const Vec2 uv = parent.quad().inverse(q.position);
        const double parameter_area = q.area / parent.quad().jacobian(uv.x(), uv.y());
        filters.pull += parameter_area * above * below.transpose();
    }
    return filters;
}

std::array<BilinearQuad, 4> uniform_children(const BilinearQuad &quad) {
    const auto child = [&](double u, double v) {
        return BilinearQuad{
            {quad.at(u, v), quad.at(u + 0.5, v), quad.at(u + 0.5, v + 0.5), quad.at(u, v + 0.5)}};
    };
    return {child(0, 0), child(0.5, 0), child(0.5, 0.5), child(0, 0.5)};
}

const std::array<std::shared_ptr<const TwoScale>, 4> &uniform_two_scale(int order) {
    static const auto all = [] {
        const BilinearQuad unit{{Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)}};
        std::array<std::array<std::shared_ptr<const TwoScale>, 4>, 4> filters;
        for (int m = 1; m <= 4; ++m)
            for (std::size_t c = 0; c < 4; ++c)
                filters[static_cast<std::size_t>(m - 1)][c] = std::make_shared<const TwoScale>(
                    two_scale(ElementBasis(m, unit), ElementBasis(m, uniform_children(unit)[c]), m));
        return filters;
    }();
    return all[static_cast<std::size_t>(order - 1)];
}

} // namespace penumbra
