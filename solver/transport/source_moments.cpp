#include "transport/source_moments.h"

#include "basis/gauss.h"
#include "transport/lambert.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace penumbra {

namespace {

/// Points of a source with their quadrature weights times G.
struct WeightedPoints {
    std::vector<Vec2> points;
    std::vector<double> weights;

    void clear() {
        points.clear();
        weights.clear();
    }
    void add(const Vec2 &p, double weight) {
        points.push_back(p);
        weights.push_back(weight);
    }
};

struct Eye {
    const Vec3 &n;
    const PlaneFrame &source;
    Vec3 base;     // the frame's origin as seen from x
    double height; // of x above the source's plane

    double facing(const Vec2 &p) const { return n.dot(base + p.x() * source.u + p.y() * source.v); }
    /// G where n . (y - x) and |y - x|^2 are known.
    double kernel(double facing, double r2) const {
        return std::max(0.0, facing) * height / (std::numbers::pi * r2 * r2);
    }
};

/// Tensor Gauss rule on a convex polygon in quads that share its first corner.
void add_far(const Eye &eye, std::span<const Vec2> piece, int n, WeightedPoints &out) {
    const GaussRule &rule = gauss_rule(n);
    for (std::size_t k = 1; k + 1 < piece.size(); k += 2) {
        const BilinearQuad quad{{piece[0], piece[k], piece[k + 1], piece[std::min(k + 2, piece.size() - 1)]}};
        for (std::size_t i = 0; i < rule.points.size(); ++i)
            for (std::size_t j = 0; j < rule.points.size(); ++j) {
                const double u = rule.points[i], v = rule.points[j];
                const Vec2 p = quad.at(u, v);
                const Vec3 d = eye.base + p.x() * eye.source.u + p.y() * eye.source.v;
                out.add(p, rule.weights[i] * rule.weights[j] * quad.jacobian(u, v) *
                               eye.kernel(eye.n.dot(d), d.squaredNorm()));
            }
    }
}

/// Gauss points on [from, to] in panels no longer than 3: in a variable graded by sinh the kernel's poles stand pi/2 off
/// the real axis, so that each panel converges as 2.5^(-2n).
class Panels {
public:
    Panels(double from, double to, int n)
        : rule_(gauss_rule(n)), count_(std::max(1, static_cast<int>(std::ceil((to - from) / 3)))), from_(from),
          width_((to - from) / count_) {}

    template <class Visit>
    void for_each(const Visit &visit) const {
        for (int k = 0; k < count_; ++k)
            for (std::size_t i = 0; i < rule_.points.size(); ++i)
                visit(from_ + width_ * (k + rule_.points[i]), width_ * rule_.weights[i]);
    }

private:
    const GaussRule &rule_;
    int count_;
    double from_, width_;
};

/// A rule for the integral of f(r) r dr over [0, 1], graded as r = sinh(s z) / sinh(z).
struct RadialRule {
    std::vector<double> radii, weights;

    void set(double z, int n) {
        radii.clear();
        weights.clear();
        const double end = std::sinh(z);
        Panels(0, z, n).for_each([&](double s, double weight) {
            const double r = std::sinh(s) / end;
            radii.push_back(r);
            weights.push_back(weight * r * std::cosh(s) / end);
        });
    }
};

/// The triangles between y* and the polygon's edges, in polar coordinates about y*.
void add_near(const Eye &eye, std::span<const Vec2> piece, const Vec2 &nearest, const Vec2 &foot_of_x, double distance,
              int n, WeightedPoints &out) {
    // One radial grading for all directions, that of the longest: shorter reaches only move the poles away.
    double longest = 0;
    for (const Vec2 &corner : piece)
        longest = std::max(longest, (corner - nearest).norm());
    thread_local RadialRule radial;
    radial.set(std::asinh(longest / distance), n);
    const double facing = eye.facing(nearest);
    const Vec2 n_plane(eye.n.dot(eye.source.u), eye.n.dot(eye.source.v));
    for (std::size_t k = 0; k < piece.size(); ++k) {
        const Vec2 a = piece[k] - nearest, b = piece[k + 1 < piece.size() ? k + 1 : 0] - nearest;
        const double length = (b - a).norm();
        if (length == 0)
            continue;
        const Vec2 along = (b - a) / length;
        const double off = std::abs(cross(along, a)); // of y* from the edge's line
        if (off <= 1e-15 * length)
            continue;
        const double from = a.dot(along), to = b.dot(along); // along the edge, 0 at the foot of y*
        const Vec2 foot = a - from * along;
        const double scale = std::max(off, distance);
        Panels(std::asinh(from / scale), std::asinh(to / scale), n).for_each([&](double w, double w_weight) {
            const Vec2 reach = foot + scale * std::sinh(w) * along;
            const double area = w_weight * scale * std::cosh(w) * off; // twice that of the triangle
            // |y - x|^2 and n . (y - x) along the ray to the edge.
            const double r2_1 = 2 * reach.dot(nearest - foot_of_x), r2_2 = reach.squaredNorm();
            const double turn = reach.dot(n_plane);
            for (std::size_t i = 0; i < radial.radii.size(); ++i) {
                const double s = radial.radii[i];
                const double r2 = distance * distance + s * (r2_1 + s * r2_2);
                out.add(nearest + s * reach, area * radial.weights[i] * eye.kernel(facing + s * turn, r2));
            }
        });
    }
}

} // namespace

void source_moments(const Vec3 &x, const Vec3 &n, const PlaneFrame &source, const ElementBasis &basis,
                    const ConvexPieces &pieces, double accuracy, std::span<double> moments, Work &work) {
    std::ranges::fill(moments, 0.0);
    const double digits = std::log(1 / accuracy);
    const Eye eye{n, source, source.origin - x, source.height(x)};
    const Vec2 foot = source.to_plane(x);
    thread_local WeightedPoints samples;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const std::span<const Vec2> piece = pieces[i];
        const double whole = lambert(x, n, source, piece);
        ++work.kernel_evaluations;
        if (moments.size() == 1) {
            moments[0] += whole;
            continue;
        }
        const Vec2 nearest = nearest_point(piece, foot);
        const double size = radius(piece);
        const double distance = std::max(std::hypot(eye.height, (foot - nearest).norm()), 1e-14 * size);
        samples.clear();
        // Gauss converges as rho^(-2n), rho the Bernstein ellipse that keeps clear of the kernel's poles.
        const double n_far = std::ceil(digits / (2 * std::asinh(distance / size)) + 2);
        // Up to where it takes no more points than the near rule; it also follows the functions of a triangle, whose
        // values at the double corner depend on the direction.
        if (n_far <= std::max(8.0, digits))
            add_far(eye, piece, static_cast<int>(n_far), samples);
        else
            add_near(eye, piece, nearest, foot, distance, static_cast<int>(std::ceil(0.45 * digits)) + 3, samples);
        work.kernel_evaluations += static_cast<std::int64_t>(samples.points.size());
        std::array<double, max_functions> sums{};
        const std::span<double> piece_moments(sums.data(), moments.size());
        basis.add_weighted(samples.points, samples.weights, piece_moments);
        // The part that Lambert's form has exactly, N_j(y*), is taken out of the rule's error.
        const BasisValues at_nearest = basis.evaluate(nearest);
        const double missing = whole - sums[0];
        for (std::size_t m = 0; m < moments.size(); ++m)
            moments[m] += piece_moments[m] + missing * at_nearest[static_cast<Eigen::Index>(m)];
    }
}

} // namespace penumbra
