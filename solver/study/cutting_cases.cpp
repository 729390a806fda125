#include "study/case_groups.h"

#include "hierarchy/cut.h"
#include "study/lit_floor.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace penumbra {

namespace {

const Vec3 o = Vec3::Zero(), x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();

Face floor() { return parallelogram(o, x, y, 0.5); }
Face lamp() { return parallelogram(Vec3(0.1, 0.2, 1), 0.3 * y, 0.3 * x, 0, 1); }

std::vector<Measurement> compare_with_direct(const Faces &in_the_light, const TrialSetting &setting) {
    Faces faces{floor(), lamp()};
    faces.insert(faces.end(), in_the_light.begin(), in_the_light.end());
    return penumbra::compare_with_direct(faces, faces, grid(o, x, y), setting);
}

/// A thousand cuts of one square, each taking a strip of a thousandth of what is left: functions go from the square
/// down to all strips and back. Of the parametric family, whose cuts lose the rest, what is kept is polynomials of the
/// plane of total degree below the order.
std::vector<Measurement> nested_cuts(const TrialSetting &setting) {
    const int order = setting.options.order;
    Forest forest = plant(*solve({floor(), lamp()}, setting).scene, order, setting.options.basis);
    const ElementId root = forest.roots[0][0];
    const Polygon outline = forest[root].basis.outline();
    ElementId rest = root;
    int n_cuts = 0;
    for (; n_cuts < 1000; ++n_cuts) {
        // Turned by turns, so that the rest stays a quad with no two sides parallel.
        const Polygon &corners = forest[rest].basis.outline();
        const std::size_t k = static_cast<std::size_t>(n_cuts) % 2;
        const Vec2 a = corners[k] + 1e-3 * (corners[(k + 3) % 4] - corners[k]),
                   b = corners[k + 1] + 1.5e-3 * (corners[(k + 2) % 4] - corners[k + 1]);
        const Vec2 along = b - a;
        const auto plan = plan_cut(forest[rest], {-along.y(), along.x(), cross(a, along)});
        if (!plan)
            break;
        cut(forest, rest, *plan, 1);
        const ElementId first = forest[rest].first_child, second(first.index + 1);
        rest = forest[first].basis.area() > forest[second].basis.area() ? first : second;
    }
    // Round trip of polynomials of the plane: their coefficients on the root, by least squares at its own points.
    const Element &whole = forest[root];
    const auto points = whole.basis.quadrature(8);
    const int n = n_planar_functions(order);
    Eigen::MatrixXd values(static_cast<Eigen::Index>(points.size()), n), at(values.rows(), whole.basis.n_functions());
    for (Eigen::Index i = 0; i < values.rows(); ++i) {
        const QuadraturePoint &q = points[static_cast<std::size_t>(i)];
        values.row(i) = legendre_products(order, q.position / std::sqrt(whole.basis.area())).transpose();
        at.row(i) = whole.basis.evaluate(q).transpose();
    }
    const Eigen::MatrixXd start = at.colPivHouseholderQr().solve(values);
    std::vector<Eigen::MatrixXd> down(forest.elements.size());
    for (std::size_t e = 0; e < down.size(); ++e) {
        const Element &element = forest.elements[e];
        if (element.surface == whole.surface)
            down[e] =
                element.parent.valid() ? Eigen::MatrixXd(element.filters->push * down[element.parent.at()]) : start;
    }
    std::vector<Eigen::MatrixXd> up(down.size());
    for (std::size_t e = down.size(); e-- > 0;) {
        const Element &element = forest.elements[e];
        if (element.surface != whole.surface)
            continue;
        const Eigen::MatrixXd here = element.leaf() ? down[e] : up[e];
        if (!element.parent.valid())
            continue;
        Eigen::MatrixXd &above = up[element.parent.at()];
        const Eigen::MatrixXd part = element.filters->pull * here;
        above = above.size() == 0 ? part : Eigen::MatrixXd(above + part);
    }
    double area = 0;
    for_each_leaf(forest, root, [&](ElementId leaf) { area += forest[leaf].basis.area(); });
    const double not_made = 1000 - n_cuts;
    if (n_cuts == 0)
        return {{"cuts that were not made", not_made, 0}};
    return {{"cuts that were not made", not_made, 0},
            {"area lost, of the square's", std::abs(area / penumbra::area(outline) - 1), 1e-12},
            {"loss of polynomials of the plane, of the largest coefficient",
             (up[root.at()] - start).cwiseAbs().maxCoeff() / start.cwiseAbs().maxCoeff(), 1e-9}};
}

/// A card and another one behind it in the light, its edge a trillionth beside the first one's.
std::vector<Measurement> close_cuts(const TrialSetting &setting) {
    return compare_with_direct({parallelogram(Vec3(0.4, 0.1, 0.3), 0.5 * x, 0.8 * y, 0),
                                parallelogram(Vec3(0.4 + 1e-12, 0.2, 0.3 - 1e-12), 0.3 * x, 0.6 * y, 0)},
                               setting);
}

/// Three cards with edges that meet one line from a corner of the lamp to the floor's middle: of each a curve goes
/// through that point.
std::vector<Measurement> three_curves(const TrialSetting &setting) {
    const Vec3 corner(0.1, 0.2, 1), middle(0.5, 0.5, 0);
    Faces cards;
    for (const auto &[height, angle] : {std::pair(0.2, 0.3), {0.3, 1.4}, {0.4, 2.5}}) {
        const Vec3 at = middle + height * (corner - middle), along(std::cos(angle), std::sin(angle), 0);
        cards.push_back(parallelogram(at - 0.1 * along, 0.2 * along, 0.15 * z.cross(along), 0));
    }
    return compare_with_direct(cards, setting);
}

/// A floor whose patches may be halved but once, under a small card: they fail, are kept and counted.
std::vector<Measurement> depth_limit(const TrialSetting &setting) {
    TrialSetting shallow = setting;
    shallow.options.max_depth = 1;
    shallow.options.strategy = Strategy::uniform_wavelet;
    const Trial trial = solve({floor(), lamp(), parallelogram(Vec3(0.4, 0.4, 0.1), 0.1 * x, 0.1 * y, 0)}, shallow);
    double deepest = 0;
    for (const Element &e : trial.state->forest.elements)
        deepest = std::max(deepest, e.depth());
    std::vector<Measurement> out = soundness(trial);
    // What the limit leaves may well be darker than the threshold says.
    std::erase_if(out, [](const Measurement &m) { return m.quantity.starts_with("fall below black"); });
    out.push_back({"halvings beyond the limit", deepest - 1, 0});
    out.push_back({"limits met and not counted", trial.state->counters.nodes_at_limit > 0 ? 0.0 : 1.0, 0});
    return out;
}

} // namespace

std::vector<HardCase> cutting_cases() {
    return {
        {"nested-cuts", "A thousand nested cuts lose neither area nor polynomials of the plane", nested_cuts},
        {"close-cuts", "Curves a trillionth apart leave the floor the light that each point sees", close_cuts},
        {"three-curves", "And so do three curves through one point", three_curves},
        {"depth-limit", "Elements that may not be halved again are kept and counted", depth_limit},
    };
}

} // namespace penumbra
