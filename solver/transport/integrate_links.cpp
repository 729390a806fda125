#include "transport/integrate_links.h"

#include "core/check.h"
#include "transport/link_orders.h"
#include "transport/lit_points.h"
#include "transport/point_transfer.h"
#include "transport/proximity.h"
#include "transport/receiver_points.h"
#include "transport/shadow_points.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace penumbra {

namespace {

using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Of the test points, every such one is looked at with all functions of the sources, before some are left out.
constexpr std::size_t probe_stride = 4;
/// A fit of lower order may turn out to miss more than least squares promised, by this factor.
constexpr double broken_promise = 2;

/// More than the oracle asks of a fit.
int digits_of(double accuracy) { return std::max(0, static_cast<int>(std::lround(-std::log10(accuracy))) - 3); }

class LinkIntegration {
public:
    LinkIntegration(const Transport &transport, const Forest &forest, Interaction &out, const Leeway &leeway,
                    double distance, Work &work)
        : transport_(transport), out_(out), leeway_(leeway), p_(forest[out.receiver]),
          to_(transport.scene.surface(p_.surface)), from_(transport.scene.surface(out.source)), distance_(distance),
          size_(radius(p_.basis.outline())), near_(distance < 0.25 * size_), work_(work) {
        if (!out.weak)
            tests_ = oracle_points(transport, p_, out, distance);
    }

    void add_node(SourceNode node) {
        if (out_.weak)
            node.n_columns = 1;
        nodes_.push_back(node);
    }

    /// Kernel, misfit and what was left out, of all nodes in their order. `order`: to be taken; 0: of its own choice.
    void run(int order) {
        if (out_.weak) {
            out_.order = 1;
            kernel = project(nodes_, transport_.accuracy);
            misfit.resize(0, kernel.cols());
            left_out.resize(nodes_.size());
            return;
        }
        const Rows transfers = look();
        ChannelValues brought = ChannelValues::Zero(transfers.rows(), 3);
        if (leeway_.misfit > 0)
            brought = transfers * radiosity();
        out_.order = order > 0 ? order : sufficient_order(p_.basis, tests_, brought, leeway_);
        fit(transfers);
        if (order == 0 && out_.order < p_.basis.order() &&
            size_of(misfit * radiosity(), leeway_) > broken_promise * leeway_.misfit) {
            out_.order = p_.basis.order();
            fit(transfers);
        }
    }

    const std::vector<SourceNode> &nodes() const { return nodes_; }
    std::size_t n_tests() const { return tests_.size(); }

    Eigen::MatrixXd kernel, misfit;
    std::vector<Eigen::VectorXd> left_out;

private:
    void look_at(std::span<const std::size_t> tests, Rows &rows) {
        PointTransfer transfer(transport_, p_, out_, nodes_, work_);
        for (const std::size_t c : tests)
            transfer.at(tests_[c], row_of(rows, c));
    }

    static std::span<double> row_of(Rows &rows, std::size_t c) {
        return {rows.data() + static_cast<Eigen::Index>(c) * rows.cols(), static_cast<std::size_t>(rows.cols())};
    }

    /// T at the tests, of the columns that are kept.
    Rows look() {
        const auto n_tests = static_cast<Eigen::Index>(tests_.size());
        std::vector<std::size_t> probes, others;
        for (std::size_t c = 0; c < tests_.size(); ++c)
            (leeway_.misfit <= 0 || c % probe_stride == 0 ? probes : others).push_back(c);
        Rows whole = Rows::Zero(n_tests, n_columns());
        look_at(probes, whole);
        left_out = columns_to_leave_out(nodes_, whole, size_, distance_, leeway_);
        std::vector<Eigen::Index> kept;
        Eigen::Index first = 0;
        for (std::size_t k = 0; k < nodes_.size(); ++k) {
            const int n = nodes_[k].n_columns;
            if (left_out[k].size() > 0)
                nodes_[k].n_columns = 1;
            for (int j = 0; j < nodes_[k].n_columns; ++j)
                kept.push_back(first + j);
            first += n;
        }
        Rows rows = whole(Eigen::all, kept);
        look_at(others, rows);
        return rows;
    }

    Eigen::Index n_columns() const {
        Eigen::Index n = 0;
        for (const SourceNode &node : nodes_)
            n += node.n_columns;
        return n;
    }

    /// Of the columns, at present.
    ChannelValues radiosity() const {
        ChannelValues b(n_columns(), 3);
        Eigen::Index first = 0;
        for (const SourceNode &node : nodes_) {
            b.middleRows(first, node.n_columns) = leeway_.radiosity->middleRows(node.element.first, node.n_columns);
            first += node.n_columns;
        }
        return b;
    }

    void fit(const Rows &transfers) {
        kernel = project(nodes_, transport_.accuracy);
        if (transport_.constant_accuracy < transport_.accuracy) {
            std::vector<SourceNode> constants = nodes_;
            for (SourceNode &node : constants)
                node.n_columns = 1;
            const Eigen::MatrixXd columns = project(constants, transport_.constant_accuracy);
            Eigen::Index column = 0;
            for (std::size_t k = 0; k < nodes_.size(); column += nodes_[k++].n_columns)
                kernel.col(column) = columns.col(static_cast<Eigen::Index>(k));
        }
        kernel.bottomRows(kernel.rows() - 1) *= out_.fit.damping;
        misfit.resize(transfers.rows(), transfers.cols());
        for (std::size_t c = 0; c < tests_.size(); ++c) {
            const auto row = static_cast<Eigen::Index>(c);
            misfit.row(row) = transfers.row(row) - lower(p_.basis.evaluate(tests_[c])).transpose() * kernel;
        }
    }

    /// Of all functions of p, those of the fit's order.
    BasisValues lower(const BasisValues &all) const {
        BasisValues out(p_.basis.n_functions(out_.order));
        for (int k = 0; k < out.size(); ++k)
            out[k] = all[p_.basis.place(out_.order, k)];
        return out;
    }

    Eigen::MatrixXd project(const std::vector<SourceNode> &nodes, double accuracy) {
        PointTransfer transfer(transport_, p_, out_, nodes, work_);
        const int order = out_.order;
        // A transfer that fits the basis is integrated by order + 1 points; for more digits than the oracle asks of a
        // fit, more.
        const int digits = digits_of(accuracy);
        const int finer = out_.fit.fine && out_.kind == PairKind::partly_hidden ? 2 : 1;
        int n_points = out_.weak ? 2 : finer * (order + 1) + digits, n_levels = near_ && !out_.weak ? digits : 0;
        if (digits > 0 && !out_.weak && out_.blockers.empty() && distance_ > 0) {
            // The transfer's poles are as far from p as the source: Gauss converges as it does in source_moments.
            const double rate = 2 * std::asinh(distance_ / size_);
            if (const double enough = std::ceil(std::log(1 / accuracy) / rate + 0.5 * order + 1); enough <= 32) {
                n_points = std::max(n_points, static_cast<int>(enough));
                n_levels = 0;
            }
        }
        Eigen::MatrixXd projected = Eigen::MatrixXd::Zero(p_.basis.n_functions(order), transfer.n_columns());
        Eigen::RowVectorXd row(transfer.n_columns());
        for (const QuadraturePoint &q :
             projection_points(p_.basis, n_points, n_levels, touching_corners(p_, to_, from_))) {
            transfer.at(q.position, std::span(row.data(), static_cast<std::size_t>(row.size())));
            projected += q.inner * lower(p_.basis.evaluate(q)) * row;
        }
        return projected;
    }

    const Transport &transport_;
    Interaction &out_;
    const Leeway &leeway_;
    const Element &p_;
    const Surface &to_, &from_;
    double distance_, size_;
    bool near_;
    Work &work_;
    std::vector<Vec2> tests_;
    std::vector<SourceNode> nodes_;
};

} // namespace

std::vector<Vec2> oracle_points(const Transport &transport, const Element &p, const Interaction &pair, double distance) {
    const Surface &to = transport.scene.surface(p.surface), &from = transport.scene.surface(pair.source);
    std::vector<Vec2> points = test_points(p.basis);
    const auto shadows = shadow_points(transport.scene, transport.blockers, p, from, pair.blockers);
    points.insert(points.end(), shadows.begin(), shadows.end());
    if (lights_a_spot(p, from, distance)) {
        // Drawn in, as shadow points are.
        const Vec2 centre = p.basis.centre();
        for (const Vec2 &at : lit_points(p, to, from))
            if (const Vec2 inside = at + 0.02 * (centre - at); from.frame.height(to.frame.to_space(inside)) > 0)
                points.push_back(inside);
    }
    std::erase_if(points, [&](const Vec2 &at) { return is_covered(to, at); });
    const auto beside = contact_points(transport.scene, transport.blockers, p, pair.blockers);
    points.insert(points.end(), beside.begin(), beside.end());
    return points;
}

void integrate_links(const Transport &transport, const Forest &forest, Interaction &out,
                     std::span<const ElementId> sources, const Leeway &leeway, double distance,
                     const Interaction *before, Work &work) {
    const bool alike = before && before->weak == out.weak && before->fit == out.fit;
    const std::span<const Link> known = alike ? before->links : std::span<const Link>();
    const auto known_link = [&](ElementId q) { return std::ranges::find(known, q, &Link::source); };
    LinkIntegration integration(transport, forest, out, leeway, distance, work);
    bool any_known = false;
    for (const ElementId q : sources)
        if (known_link(q) == known.end())
            integration.add_node(source_node(transport.scene, forest[q]));
        else
            any_known = true;
    integration.run(any_known ? before->order : 0);

    Eigen::Index first = 0;
    std::size_t k = 0;
    for (const ElementId q : sources) {
        if (const auto link = known_link(q); link != known.end()) {
            PENUMBRA_CHECK(link->misfit.rows(), ==, integration.misfit.rows());
            out.links.push_back(*link);
            continue;
        }
        const Eigen::Index count = integration.nodes()[k].n_columns;
        out.links.push_back({q, integration.kernel.middleCols(first, count), integration.misfit.middleCols(first, count),
                             std::move(integration.left_out[k++])});
        first += count;
    }
}

} // namespace penumbra
