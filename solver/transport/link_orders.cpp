#include "transport/link_orders.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace penumbra {

double size_of(const ChannelValues &misfits, const Leeway &leeway) {
    if (misfits.rows() == 0)
        return 0;
    const Rgb &rho = leeway.reflectance;
    if (leeway.mean_square)
        return std::sqrt((rho.square() * misfits.array().square().colwise().mean().transpose()).sum());
    return (rho * misfits.cwiseAbs().colwise().maxCoeff().transpose().array()).maxCoeff();
}

int sufficient_order(const ElementBasis &p, std::span<const Vec2> points, const ChannelValues &values,
                     const Leeway &leeway) {
    const int lower = p.order() - 1;
    const auto n_points = static_cast<Eigen::Index>(points.size());
    if (lower < 1 || leeway.misfit <= 0 || n_points <= p.n_functions(lower))
        return p.order();
    // Columns by order, so that the first n(m) of them are the functions of order m.
    std::vector<int> columns;
    for (int m = 1; m <= lower; ++m)
        for (int k = 0; k < p.n_functions(m); ++k)
            if (const int at = p.place(m, k); std::ranges::find(columns, at) == columns.end())
                columns.push_back(at);
    Eigen::MatrixXd functions(n_points, static_cast<Eigen::Index>(columns.size()));
    for (Eigen::Index i = 0; i < n_points; ++i) {
        const BasisValues at = p.evaluate(points[static_cast<std::size_t>(i)]);
        for (std::size_t k = 0; k < columns.size(); ++k)
            functions(i, static_cast<Eigen::Index>(k)) = at[columns[k]];
    }
    const Eigen::HouseholderQR<Eigen::MatrixXd> qr(functions);
    const ChannelValues rotated = qr.householderQ().transpose() * values;
    for (int m = 1; m <= lower; ++m) {
        ChannelValues rest = rotated;
        rest.topRows(p.n_functions(m)).setZero();
        if (!leeway.mean_square)
            rest = qr.householderQ() * rest;
        if (size_of(rest, leeway) <= leeway.misfit)
            return m;
    }
    return p.order();
}

std::vector<Eigen::VectorXd> columns_to_leave_out(std::span<const SourceNode> nodes, const Eigen::MatrixXd &transfers, double size, double distance,
                                                  const Leeway &leeway) {
    std::vector<Eigen::VectorXd> out(nodes.size());
    if (leeway.misfit <= 0 || transfers.rows() == 0)
        return out;
    struct Node {
        std::size_t index;
        Eigen::VectorXd largest;
        double brings;
    };
    std::vector<Node> all;
    Eigen::Index first = 0;
    for (std::size_t k = 0; k < nodes.size(); first += nodes[k++].n_columns) {
        const int n = nodes[k].n_columns - 1;
        const ElementBasis &q = nodes[k].element.basis;
        const double width = q.area() / radius(q.outline());
        if (n < 1 || (distance < width && width < size))
            continue;
        Node node{k, transfers.middleCols(first + 1, n).cwiseAbs().colwise().maxCoeff().transpose(), 0};
        const Rgb most = (node.largest.transpose() * leeway.radiosity->middleRows(nodes[k].element.first + 1, n).cwiseAbs())
                             .transpose()
                             .array();
        node.brings = (leeway.reflectance * most).maxCoeff();
        all.push_back(std::move(node));
    }
    std::ranges::sort(all, {}, &Node::brings);
    double sum = 0;
    for (Node &node : all) {
        sum += node.brings;
        if (sum > leeway.misfit)
            break;
        out[node.index] = std::move(node.largest);
    }
    return out;
}

} // namespace penumbra
