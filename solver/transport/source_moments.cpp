#include "transport/source_moments.h"

#include "transport/lambert.h"
#include "transport/moment_rules.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace penumbra {

namespace {

/// Whether a tensor rule on this piece follows the functions of a triangle into its double corner: it does on the whole
/// triangle, whose last corner it doubles, too.
bool doubles_the_same_corner(const BilinearQuad &triangle, std::span<const Vec2> piece) {
    return piece.size() == 3 && piece[2] == triangle.corners[2] && piece[2] == triangle.corners[3];
}

} // namespace

void source_moments(const Vec3 &x, const Vec3 &n, const PlaneFrame &source, const ElementBasis &basis,
                    const ConvexPieces &pieces, double accuracy, std::span<double> moments, Work &work) {
    std::ranges::fill(moments, 0.0);
    const double digits = std::log(1 / accuracy);
    const Eye eye(x, n, source);
    const BilinearQuad *triangle = basis.quad() && basis.outline().size() == 3 ? basis.quad() : nullptr;
    thread_local WeightedPoints samples;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const std::span<const Vec2> piece = pieces[i];
        const double whole = lambert(x, n, source, piece);
        ++work.kernel_evaluations;
        if (moments.size() == 1) {
            moments[0] += whole;
            continue;
        }
        const Vec2 nearest = nearest_point(piece, eye.foot);
        const double size = radius(piece);
        const double distance = std::max(eye.distance(nearest), 1e-14 * size);
        samples.clear();
        // Gauss converges as rho^(-2n), rho the Bernstein ellipse that keeps clear of the kernel's poles; the rest is
        // for what the kernel is multiplied with. Products in parameters are of twice the degree in those of a part.
        const int more = basis.quad() && !std::ranges::equal(piece, basis.outline()) ? basis.order() - 1 : 0;
        const double n_far = std::ceil(digits / (2 * std::asinh(distance / size)) + 2 + 0.5 * more);
        const int n_near = static_cast<int>(std::ceil(0.45 * digits)) + 3;
        // Far: up to where it takes no more points than the near rule.
        if (n_far <= std::max(8.0, digits) && (!triangle || doubles_the_same_corner(*triangle, piece)))
            add_far(eye, piece, static_cast<int>(n_far), samples);
        else if (triangle)
            add_fan(eye, piece, *triangle, n_near, samples);
        else
            add_near(eye, piece, nearest, distance, n_near, samples);
        work.kernel_evaluations += static_cast<std::int64_t>(samples.points.size());
        std::array<double, max_functions> sums{};
        const std::span<double> piece_moments(sums.data(), moments.size());
        basis.add_weighted(samples.points, samples.weights, piece_moments);
        // The part that Lambert's form has exactly, N_j(y*), is taken out of the rule's error.
        // At a double corner a direction has no digits: it is kept within the triangle.
        const BasisValues at_nearest =
            triangle
                ? basis.evaluate(QuadraturePoint{nearest, triangle->inverse(nearest).cwiseMax(0.0).cwiseMin(1.0), 0, 0})
                : basis.evaluate(nearest);
        const double missing = whole - sums[0];
        for (std::size_t m = 0; m < moments.size(); ++m)
            moments[m] += piece_moments[m] + missing * at_nearest[static_cast<Eigen::Index>(m)];
    }
}

} // namespace penumbra
