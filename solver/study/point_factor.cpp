#include "study/point_factor.h"

#include <cmath>
#include <numbers>

namespace penumbra {

double point_factor(const Vec3 &x, const Vec3 &n, std::span<const Vec3> polygon) {
    double sum = 0;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vec3 a = polygon[k] - x, b = polygon[(k + 1) % polygon.size()] - x, across = a.cross(b);
        const double length = across.norm();
        if (length > 0)
            sum += std::atan2(length, a.dot(b)) * across.dot(n) / length;
    }
    return -sum / (2 * std::numbers::pi);
}

} // namespace penumbra
