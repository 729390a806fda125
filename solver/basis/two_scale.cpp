#include "basis/two_scale.h"

#include "basis/gauss.h"
#include "geometry/convex_pieces.h"

#include <algorithm>

namespace penumbra {

namespace {

/// Side of the quad that has no length: side k runs from corner k to the next. None: -1.
int side_without_length(const BilinearQuad &quad) {
    for (int k = 0; k < 4; ++k)
        if (quad.corners[static_cast<std::size_t>(k)] == quad.corners[static_cast<std::size_t>((k + 1) % 4)])
            return k;
    return -1;
}

/// Pull from a child of a triangle. The parent's parameters are polar about the corner that is two corners in one, where
/// its Jacobian vanishes and a rule in the child's parameters would meet a pole; so this one runs along the rays from
/// that corner, in panels of rays that end on the same two sides of the child.
Eigen::MatrixXd polar_pull(const ElementBasis &parent, const ElementBasis &child, int side, int n) {
    const BilinearQuad &quad = *parent.quad();
    const bool rays_along_v = side % 2 == 0; // then u tells the rays apart
    const auto at = [&](double ray, double along) { return rays_along_v ? quad.at(ray, along) : quad.at(along, ray); };
    const Vec2 &apex = quad.corners[static_cast<std::size_t>(side)];
    const std::vector<HalfPlane> borders = half_planes(child.outline());

    std::vector<double> breaks;
    for (const Vec2 &corner : child.outline())
        if (corner != apex) {
            const Vec2 uv = quad.inverse(corner);
            breaks.push_back(std::clamp(rays_along_v ? uv.x() : uv.y(), 0.0, 1.0));
        }
    std::ranges::sort(breaks);

    const GaussRule &rule = gauss_rule(n);
    Eigen::MatrixXd pull = Eigen::MatrixXd::Zero(parent.n_functions(), child.n_functions());
    for (std::size_t k = 0; k + 1 < breaks.size(); ++k)
        for (std::size_t i = 0; i < rule.points.size(); ++i) {
            const double panel = breaks[k + 1] - breaks[k], ray = breaks[k] + panel * rule.points[i];
            const Vec2 from = at(ray, 0), to = at(ray, 1);
            double low = 0, high = 1;
            for (const HalfPlane &h : borders) {
                const double a = h.value(from), b = h.value(to);
                if (a < b)
                    low = std::max(low, a / (a - b));
                else if (b < a)
                    high = std::min(high, a / (a - b));
            }
            for (std::size_t j = 0; j < rule.points.size() && low < high; ++j) {
                const Vec2 p = at(ray, low + (high - low) * rule.points[j]);
                const double weight = panel * rule.weights[i] * (high - low) * rule.weights[j];
                pull += weight * parent.evaluate(p) * child.evaluate(p).transpose();
            }
        }
    return pull;
}

} // namespace

namespace {

/// In the two frames alone: no digit is lost in a sliver. The rule is exact for products of the two bases.
TwoScale planar_two_scale(const ElementBasis &parent, const ElementBasis &child) {
    TwoScale filters{Eigen::MatrixXd::Zero(child.n_functions(), parent.n_functions()), {}};
    const PlanarDomain &domain = child.planar()->domain;
    for (const QuadraturePoint &q : child.quadrature(std::max(parent.order(), child.order()) + 1))
        filters.push +=
            q.inner * child.evaluate(q) * parent.planar()->evaluate(domain.to_parent()(q.own)).transpose();
    filters.pull = domain.share_of_parent(parent.planar()->domain) * filters.push.transpose();
    return filters;
}

} // namespace

TwoScale two_scale(const ElementBasis &parent, const ElementBasis &child, int n) {
    if (parent.planar())
        return planar_two_scale(parent, child);
    TwoScale filters{Eigen::MatrixXd::Zero(child.n_functions(), parent.n_functions()),
                     Eigen::MatrixXd::Zero(parent.n_functions(), child.n_functions())};
    for (const QuadraturePoint &q : child.quadrature(n)) {
        const BasisValues above = parent.evaluate(q.position), below = child.evaluate(q);
        filters.push += q.inner * below * above.transpose();
        // A(u',v') of (7): parameter area of the parent per parameter area of the child.
        const Vec2 uv = parent.quad()->inverse(q.position);
        const double parameter_area = q.area / parent.quad()->jacobian(uv.x(), uv.y());
        filters.pull += parameter_area * above * below.transpose();
    }
    const int side = side_without_length(*parent.quad());
    if (side >= 0)
        filters.pull = polar_pull(parent, child, side, n);
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
