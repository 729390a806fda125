#include "geometry/bilinear_quad.h"

#include "core/check.h"

#include <cmath>

namespace penumbra {

Vec2 BilinearQuad::at(double u, double v) const {
    return (1 - v) * ((1 - u) * corners[0] + u * corners[1]) + v * ((1 - u) * corners[3] + u * corners[2]);
}

double BilinearQuad::jacobian(double u, double v) const {
    const Vec2 du = (1 - v) * (corners[1] - corners[0]) + v * (corners[2] - corners[3]);
    const Vec2 dv = (1 - u) * (corners[3] - corners[0]) + u * (corners[2] - corners[1]);
    return std::abs(cross(du, dv));
}

Vec2 BilinearQuad::inverse(const Vec2 &p) const {
    // p - c0 = u a + v b + uv d; eliminating u leaves k0 + k1 v + k2 v^2 = 0, whose wanted root has a positive
    // derivative there (it is the Jacobian of a counter-clockwise convex quad).
    const Vec2 a = corners[1] - corners[0], b = corners[3] - corners[0];
    const Vec2 d = corners[0] - corners[1] + corners[2] - corners[3];
    const Vec2 h = p - corners[0];
    const double k0 = cross(h, a), k1 = cross(h, d) + cross(a, b), k2 = -cross(b, d);
    const double root = std::sqrt(std::max(0.0, k1 * k1 - 4 * k2 * k0));
    double v = 0;
    if (k1 >= 0)
        v = k1 + root > 0 ? -2 * k0 / (k1 + root) : 0.0;
    else
        v = (root - k1) / (2 * k2);
    const Vec2 along = a + v * d;
    const double length2 = along.squaredNorm();
    const double u = length2 > 0 ? (h - v * b).dot(along) / length2 : 0.5;
    return {u, v};
}

Polygon BilinearQuad::outline() const {
    Polygon out;
    for (std::size_t i = 0; i < 4; ++i)
        if (corners[i] != corners[(i + 1) % 4])
            out.push_back(corners[i]);
    return out;
}

BilinearQuad bilinear_quad(std::span<const Vec2> polygon) {
    PENUMBRA_CHECK(polygon.size(), >=, 3u);
    PENUMBRA_CHECK(polygon.size(), <=, 4u);
    return {{polygon[0], polygon[1], polygon[2], polygon.back()}};
}

} // namespace penumbra
