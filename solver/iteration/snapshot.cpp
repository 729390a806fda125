#include "iteration/snapshot.h"

#include <algorithm>
#include <cmath>

namespace penumbra {
namespace {

std::array<double, 4> legendre(double x) {
    const double t = 2 * x - 1;
    return {1, std::sqrt(3.0) * t, std::sqrt(5.0) * (1.5 * t * t - 0.5), std::sqrt(7.0) * (2.5 * t * t - 1.5) * t};
}

/// Parameters of p in the bilinear quad. With h = p - c0 = u b + v (c + u d), cross(h - u b, c + u d) = 0 is a quadratic
/// in u alone; of its roots the one inside a convex quad is where it falls (its slope is minus the Jacobian), so no
/// case needs to be told apart: parallelograms, trapezoids and triangles all end in the same division.
Vec2 parameters(const std::array<Vec2, 4> &corners, const Vec2 &p) {
    const Vec2 b = corners[1] - corners[0], c = corners[3] - corners[0], d = corners[2] - corners[3] - b;
    const Vec2 h = p - corners[0];
    const double q2 = -cross(b, d), q1 = cross(h, d) - cross(b, c), q0 = cross(h, c);
    const double root = std::sqrt(std::max(0.0, q1 * q1 - 4 * q2 * q0));
    const double u_raw = q1 <= 0 ? 2 * q0 / (root - q1) : -(q1 + root) / (2 * q2);
    const double u = std::isfinite(u_raw) ? std::clamp(u_raw, 0.0, 1.0) : 0.5; // an apex has any u
    const Vec2 across = c + u * d;
    const double v_raw = (h - u * b).dot(across) / across.squaredNorm();
    return {u, std::isfinite(v_raw) ? std::clamp(v_raw, 0.0, 1.0) : 0.5};
}

} // namespace

std::string_view name(Phase phase) {
    switch (phase) {
    case Phase::start:
        return "start";
    case Phase::refined:
        return "refine";
    case Phase::gathered:
        return "gather";
    case Phase::pushed_pulled:
        return "push-pull";
    }
    return "";
}

Rgb radiosity_at(const Snapshot &snapshot, const SnapshotPatch &patch, double u, double v) {
    const auto lu = legendre(u), lv = legendre(v);
    Rgb sum = Rgb::Zero();
    for (int i = 0; i < patch.order; ++i)
        for (int j = 0; j < patch.order; ++j)
            sum += snapshot.coefficients[static_cast<std::size_t>(patch.first + i * patch.order + j)] *
                   (lu[static_cast<std::size_t>(i)] * lv[static_cast<std::size_t>(j)]);
    return sum;
}

Rgb radiosity(const Snapshot &snapshot, const SnapshotPatch &patch, const Vec2 &p) {
    const Vec2 uv = parameters(patch.corners, p);
    return radiosity_at(snapshot, patch, uv.x(), uv.y());
}

} // namespace penumbra
