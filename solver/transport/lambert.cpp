#include "transport/lambert.h"

#include <cmath>
#include <numbers>

namespace penumbra {

double lambert(const Vec3 &x, const Vec3 &n, const PlaneFrame &source, std::span<const Vec2> polygon) {
    const Vec3 base = source.origin - x;
    const auto towards = [&](const Vec2 &p) { return Vec3(base + p.x() * source.u + p.y() * source.v); };
    double sum = 0;
    Vec3 from = towards(polygon.back());
    for (const Vec2 &p : polygon) {
        const Vec3 to = towards(p);
        const Vec3 normal = to.cross(from); // towards the polygon's inside, as it is seen from x
        const double sine = normal.norm();
        if (sine > 0)
            sum += std::atan2(sine, from.dot(to)) * normal.dot(n) / sine;
        from = to;
    }
    return std::max(0.0, sum / (2 * std::numbers::pi));
}

} // namespace penumbra
