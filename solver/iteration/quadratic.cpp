#include "iteration/quadratic.h"

#include "core/parallel.h"

#include <Eigen/QR>

#include <vector>

namespace penumbra {

namespace {

constexpr int order = 3;
constexpr double drawn_in = 1e-3;

struct Nodes {
    std::vector<Vec2> points;
    Eigen::MatrixXd values; ///< nodes x functions
};

Nodes nodes_of(const ElementBasis &basis) {
    Nodes nodes;
    std::vector<BasisValues> rows;
    if (basis.quad()) {
        for (const double u : {drawn_in, 0.5, 1 - drawn_in})
            for (const double v : {drawn_in, 0.5, 1 - drawn_in}) {
                const QuadraturePoint q = basis.at_parameters(0, u, v);
                nodes.points.push_back(q.position);
                rows.push_back(basis.evaluate(q));
            }
    } else {
        const Vec2 centre = basis.centre();
        const Polygon &corners = basis.outline();
        nodes.points.push_back(centre);
        for (std::size_t i = 0; i < corners.size(); ++i)
            for (const Vec2 &p : {corners[i], Vec2((corners[i] + corners[(i + 1) % corners.size()]) / 2)})
                nodes.points.push_back(p + drawn_in * (centre - p));
        for (const Vec2 &p : nodes.points)
            rows.push_back(basis.evaluate(p));
    }
    nodes.values.resize(static_cast<Eigen::Index>(rows.size()), basis.n_functions());
    for (std::size_t i = 0; i < rows.size(); ++i)
        nodes.values.row(static_cast<Eigen::Index>(i)) = rows[i].transpose();
    return nodes;
}

ElementBasis with_order(const ElementBasis &basis) {
    return basis.quad() ? ElementBasis(order, *basis.quad()) : ElementBasis(order, basis.planar()->domain);
}

} // namespace

QuadraticField reconstruct(const Setting &setting, const State &state, const Cancel *cancel) {
    QuadraticField field{state.forest, {}};
    Forest &forest = field.forest;
    forest.n_coefficients = 0;
    for (Element &e : forest.elements) {
        e.basis = with_order(e.basis);
        e.first = forest.n_coefficients;
        forest.n_coefficients += e.basis.n_functions();
    }
    field.radiosity.setZero(forest.n_coefficients, 3);
    const Transport transport = setting.transport(state.counters.threshold, cancel);
    parallel_for(forest.elements.size(), [&](std::size_t i) {
        const Element &leaf = forest.elements[i];
        if (!leaf.leaf())
            return;
        const Nodes nodes = nodes_of(leaf.basis);
        Eigen::Matrix<double, Eigen::Dynamic, 3> values(nodes.values.rows(), 3);
        values.setZero();
        if (setting.scene->reflects(leaf.surface)) {
            Work work;
            for (ElementId e(i); e.valid(); e = forest[e].parent)
                for (const auto &interaction : state.interactions[e.at()])
                    values += sample(transport, state.forest, *interaction, nodes.points, state.radiosity, work);
            values *= setting.reflectance(leaf.surface).matrix().asDiagonal();
        }
        values.rowwise() += setting.scene->exitance(leaf.surface).matrix().transpose();
        field.radiosity.middleRows(leaf.first, leaf.basis.n_functions()) =
            nodes.values.colPivHouseholderQr().solve(values);
    });
    return field;
}

} // namespace penumbra
