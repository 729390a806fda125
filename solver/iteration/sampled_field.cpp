#include "iteration/sampled_field.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace penumbra {

namespace {

constexpr int grid = 12, small_grid = 6; // samples a parameter: of the node, and of a small piece that a cut makes

using Samples = Eigen::Matrix<double, Eigen::Dynamic, 3>;

} // namespace

SampledField sample_field(const Setting &setting, const Transport &transport, const State &state, const Element &node,
                          std::span<const Interaction *const> failing, std::span<const ElementBasis> small_pieces,
                          Work &work) {
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
        const double n_tiles = static_cast<double>(piece.n_tiles());
        for (const BilinearQuad &tile : piece.tiles())
            grids.push_back({tile, tile.outline(), static_cast<int>(std::ceil(n / std::sqrt(n_tiles)))});
    };
    add(node.basis, grid);
    for (const ElementBasis &piece : small_pieces)
        add(piece, small_grid);
    SampledField field;
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

namespace {

ElementBasis with_order(const ElementBasis &basis, int order) {
    return basis.quad() ? ElementBasis(order, *basis.quad()) : ElementBasis(order, basis.planar()->domain);
}

} // namespace

double misfit(const SampledField &field, const ElementBasis &element) {
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

double misfit(const SampledField &field, std::span<const ElementBasis> elements) {
    double sum = 0;
    for (const ElementBasis &element : elements)
        sum += misfit(field, element);
    return sum;
}

} // namespace penumbra
