#include "transport/source_moments.h"

#include "basis/gauss.h"
#include "transport/lambert.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace penumbra {

namespace {

using Moments = std::span<double>;

struct Eye {
    Vec3 x, n;
    const PlaneFrame &source;
    Vec3 base; // the frame's origin as seen from x

    double kernel(const Vec2 &p) const {
        const Vec3 d = base + p.x() * source.u + p.y() * source.v;
        const double r2 = d.squaredNorm();
        return std::max(0.0, n.dot(d)) * -source.normal.dot(d) / (std::numbers::pi * r2 * r2);
    }
};

/// Tensor Gauss rule on a convex polygon in quads that share its first corner.
void add_far(const Eye &eye, const ElementBasis &basis, std::span<const Vec2> piece, int n, Moments moments, Work &work) {
    const GaussRule &rule = gauss_rule(n);
    for (std::size_t k = 1; k + 1 < piece.size(); k += 2) {
        const BilinearQuad quad{{piece[0], piece[k], piece[k + 1], piece[std::min(k + 2, piece.size() - 1)]}};
        for (std::size_t i = 0; i < rule.points.size(); ++i)
            for (std::size_t j = 0; j < rule.points.size(); ++j) {
                const double u = rule.points[i], v = rule.points[j];
                const Vec2 p = quad.at(u, v);
                const double g = rule.weights[i] * rule.weights[j] * quad.jacobian(u, v) * eye.kernel(p);
                const BasisValues value = basis.evaluate(p);
                for (std::size_t m = 1; m < moments.size(); ++m)
                    moments[m] += g * value[static_cast<Eigen::Index>(m)];
            }
        work.kernel_evaluations += n * n;
    }
}

/// Gauss points on [from, to] in panels no longer than 3: in a variable graded by sinh the kernel's poles stand pi/2 off
/// the real axis, so that each panel converges as 2.5^(-2n).
class Panels {
public:
    Panels(double from, double to, int n)
        : rule_(gauss_rule(n)), count_(std::max(1, static_cast<int>(std::ceil((to - from) / 3)))), from_(from),
          width_((to - from) / count_) {}

    int size() const { return count_ * static_cast<int>(rule_.points.size()); }
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

/// G (N_j - N_j(y*)) over the triangles between y* and the polygon's edges.
void add_near(const Eye &eye, const ElementBasis &basis, std::span<const Vec2> piece, const Vec2 &nearest, double distance,
              const BasisValues &at_nearest, int n, Moments moments, Work &work) {
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
            const Vec2 q = foot + scale * std::sinh(w) * along;
            const double reach = q.norm();
            const double angle = w_weight * scale * std::cosh(w) * off / (reach * reach);
            const Panels radial(0, std::asinh(reach / distance), n);
            radial.for_each([&](double z, double z_weight) {
                const double r = distance * std::sinh(z);
                const Vec2 p = nearest + (r / reach) * q;
                const double g = angle * z_weight * distance * std::cosh(z) * r * eye.kernel(p);
                const BasisValues value = basis.evaluate(p);
                for (std::size_t m = 1; m < moments.size(); ++m)
                    moments[m] += g * (value[static_cast<Eigen::Index>(m)] - at_nearest[static_cast<Eigen::Index>(m)]);
            });
            work.kernel_evaluations += radial.size();
        });
    }
}

} // namespace

void source_moments(const Vec3 &x, const Vec3 &n, const PlaneFrame &source, const ElementBasis &basis,
                    const ConvexPieces &pieces, double accuracy, std::span<double> moments, Work &work) {
    std::ranges::fill(moments, 0.0);
    const double digits = std::log(1 / accuracy);
    const Eye eye{x, n, source, source.origin - x};
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const std::span<const Vec2> piece = pieces[i];
        const double whole = lambert(x, n, source, piece);
        ++work.kernel_evaluations;
        moments[0] += whole;
        if (moments.size() == 1)
            continue;
        const Vec2 foot = source.to_plane(x);
        const Vec2 nearest = nearest_point(piece, foot);
        const double size = radius(piece);
        const double distance = std::max(std::hypot(source.height(x), (foot - nearest).norm()), 1e-14 * size);
        // Gauss converges as rho^(-2n), rho the Bernstein ellipse that keeps clear of the kernel's poles.
        const double n_far = std::ceil(digits / (2 * std::asinh(distance / size)) + 2);
        if (n_far <= 8) {
            add_far(eye, basis, piece, static_cast<int>(n_far), moments, work);
        } else {
            const BasisValues at_nearest = basis.evaluate(nearest);
            for (std::size_t m = 1; m < moments.size(); ++m)
                moments[m] += whole * at_nearest[static_cast<Eigen::Index>(m)];
            const int n_near = static_cast<int>(std::ceil(0.45 * digits)) + 3;
            add_near(eye, basis, piece, nearest, distance, at_nearest, n_near, moments, work);
        }
    }
}

} // namespace penumbra
