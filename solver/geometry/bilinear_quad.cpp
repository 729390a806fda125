#include "geometry/bilinear_quad.h"

#include "core/check.h"

#include <limits>

namespace penumbra {

Vec2 BilinearQuad::at(double u, double v) const {
    return (1 - v) * ((1 - u) * corners[0] + u * corners[1]) + v * ((1 - u) * corners[3] + u * corners[2]);
}

double BilinearQuad::jacobian(double u, double v) const {
    const Vec2 du = (1 - v) * (corners[1] - corners[0]) + v * (corners[2] - corners[3]);
    const Vec2 dv = (1 - u) * (corners[3] - corners[0]) + u * (corners[2] - corners[1]);
    return std::abs(cross(du, dv));
}

Vec2 BilinearQuad::inverse(const Vec2 &p) const { return BilinearInverse(*this)(p); }

BilinearInverse::BilinearInverse(const BilinearQuad &quad)
    : origin_(quad.corners[0]), a_(quad.corners[1] - origin_), b_(quad.corners[3] - origin_),
      d_(quad.corners[2] - quad.corners[1] - b_), ab_(cross(a_, b_)), k2_(-cross(b_, d_)), over_area_(1 / ab_) {
    double largest = 0;
    for (const Vec2 &c : quad.corners)
        largest = std::max(largest, c.cwiseAbs().maxCoeff());
    parallelogram_ = d_.cwiseAbs().maxCoeff() <= 4 * std::numeric_limits<double>::epsilon() * largest;
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
