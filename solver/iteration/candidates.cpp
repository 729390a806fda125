#include "iteration/candidates.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace penumbra {

namespace {

constexpr int grid = 12, small_grid = 6; // samples a parameter: of the node, and of a small piece that a cut makes
constexpr double small = 0.25;           // of the node's area
constexpr std::size_t most_cuts = 24; // of one node that are scored, the longest first

using Samples = Eigen::Matrix<double, Eigen::Dynamic, 3>;

/// Reflected radiosity that the failing sources bring to points of the node, each with the area it stands for.
struct Field {
    std::vector<Vec2> points;
    std::vector<double> areas;
    Samples values;
};

/// A grid over the node and one over every small piece that a cut would make, so that a narrow penumbra is seen. Where
/// grids overlap a point stands for the inverse of their densities' sum.
Field sample_field(const Setting &setting, const Transport &transport, const State &state, const Element &node,
                   std::span<const Interaction *const> failing, std::span<const ElementBasis> small_pieces, Work &work) {
    struct Grid {
        BilinearQuad quad;
        Polygon outline;
        int n;
        double density(const Vec2 &p) const {
            if (!contains(outline, p))
                return 0;
            const Vec2 uv = quad.inverse(p);
            return n * n / std::max(quad.jacobian(uv.x(), uv.y()), 1e-300);
        }
    };
    std::vector<Grid> grids;
    const auto add = [&](const ElementBasis &piece, int n) {
        const std::vector<BilinearQuad> tiles = piece.tiles();
        const int n_tile = static_cast<int>(std::ceil(n / std::sqrt(static_cast<double>(tiles.size()))));
        for (const BilinearQuad &tile : tiles)
            grids.push_back({tile, tile.outline(), n_tile});
    };
    add(node.basis, grid);
    for (const ElementBasis &piece : small_pieces)
        add(piece, small_grid);
    Field field;
    for (const Grid &g : grids)
        for (int i = 0; i < g.n; ++i)
            for (int j = 0; j < g.n; ++j) {
                const Vec2 p = g.quad.at((i + 0.5) / g.n, (j + 0.5) / g.n);
                double density = 0;
                for (const Grid &other : grids)
                    density += other.density(p);
                field.points.push_back(p);
                field.areas.push_back(1 / density);
            }
    field.values = Samples::Zero(static_cast<Eigen::Index>(field.points.size()), 3);
    for (const Interaction *interaction : failing)
        field.values += sample(transport, state.forest, *interaction, field.points, state.radiosity, work);
    field.values *= setting.reflectance(node.surface).matrix().asDiagonal();
    return field;
}

/// The basis of lower order on the same domain.
ElementBasis with_order(const ElementBasis &basis, int order) {
    return basis.quad() ? ElementBasis(order, *basis.quad()) : ElementBasis(order, basis.planar()->domain);
}

/// Squared error of the least-squares fit over the element. With few samples the degree is lowered so that there are at
/// least two samples a coefficient: a fit through all points would show nothing.
double misfit(const Field &field, const ElementBasis &element) {
    std::vector<Eigen::Index> inside;
    for (std::size_t i = 0; i < field.points.size(); ++i)
        if (contains(element.outline(), field.points[i]))
            inside.push_back(static_cast<Eigen::Index>(i));
    if (inside.empty())
        return 0;
    ElementBasis basis = element;
    while (basis.order() > 1 && 2 * basis.n_functions() > static_cast<int>(inside.size()))
        basis = with_order(element, basis.order() - 1);
    Eigen::MatrixXd a(static_cast<Eigen::Index>(inside.size()), basis.n_functions());
    Samples values(a.rows(), 3);
    for (Eigen::Index i = 0; i < a.rows(); ++i) {
        const auto from = static_cast<std::size_t>(inside[static_cast<std::size_t>(i)]);
        const double weight = std::sqrt(field.areas[from]);
        a.row(i) = weight * basis.evaluate(field.points[from]).transpose();
        values.row(i) = weight * field.values.row(static_cast<Eigen::Index>(from));
    }
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(a);
    return (values - a * qr.solve(values)).squaredNorm();
}

double misfit(const Field &field, std::span<const ElementBasis> elements) {
    double sum = 0;
    for (const ElementBasis &element : elements)
        sum += misfit(field, element);
    return sum;
}

struct CurveCut {
    CurveId curve;
    double length; // inside the node
    CutPlan plan;
};

std::vector<CurveCut> curve_cuts(const Setting &setting, const Element &node,
                                 std::span<const Interaction *const> failing) {
    std::vector<CurveCut> cuts;
    std::vector<SurfaceId> sources;
    for (const Interaction *interaction : failing)
        sources.push_back(interaction->source);
    for (const CurveSegment &segment : setting.curves.crossing(node.surface, node.basis.outline(), sources)) {
        const Vec2 d = (segment.to - segment.from).normalized();
        if (auto plan = plan_cut(node, {-d.y(), d.x(), cross(segment.from, d)}))
            cuts.push_back({segment.curve, (segment.to - segment.from).norm(), std::move(*plan)});
    }
    std::ranges::stable_sort(cuts, std::greater<>(), &CurveCut::length);
    if (cuts.size() > most_cuts)
        cuts.resize(most_cuts);
    return cuts;
}

} // namespace

std::optional<Split> best_split(const Setting &setting, const Transport &transport, const State &state, ElementId id,
                                std::span<const Interaction *const> failing, Work &work) {
    const Element &node = state.forest[id];
    const bool may_subdivide = node.half_depth + uniform_half_depth(node.basis) <= 2 * setting.options.max_depth;
    std::vector<CurveCut> cuts;
    if (cuts_along_curves(setting.options.strategy))
        cuts = curve_cuts(setting, node, failing);
    if (cuts.empty())
        return may_subdivide ? std::optional(Split{}) : std::nullopt;
    if (cuts.size() == 1 && !may_subdivide)
        return Split{cuts[0].plan, cuts[0].curve, 0};

    std::vector<ElementBasis> small_pieces;
    for (const CurveCut &candidate : cuts)
        for (const ElementBasis &piece : candidate.plan.leaves())
            if (piece.area() < small * node.basis.area())
                small_pieces.push_back(piece);
    const Field field = sample_field(setting, transport, state, node, failing, small_pieces, work);
    const double now = misfit(field, node.basis);
    const auto score = [&](std::span<const ElementBasis> children) {
        const double added = static_cast<double>(children.size() - 1) * node.basis.n_functions();
        return (now - misfit(field, children)) / added;
    };
    std::optional<Split> best;
    if (may_subdivide)
        best = Split{std::nullopt, std::nullopt, score(uniform_children(node))};
    for (const CurveCut &candidate : cuts) {
        const double value = score(candidate.plan.leaves());
        if (!best || value > best->score)
            best = Split{candidate.plan, candidate.curve, value};
    }
    return best;
}

} // namespace penumbra
