#include "reference/rays.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace penumbra::reference {

bool inside(const std::vector<Vec2> &polygon, const Vec2 &p) {
    bool in = false;
    for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
        const Vec2 &a = polygon[i], &b = polygon[j];
        if ((a.y() > p.y()) != (b.y() > p.y()) && p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
            in = !in;
    }
    return in;
}

bool covered(const Surface &surface, const Vec2 &p) {
    return std::ranges::any_of(surface.covers, [&](const auto &cover) { return inside(cover, p); });
}

std::optional<Hit> trace(const Scene &scene, const Vec3 &origin, const Vec3 &direction, double least, double most) {
    std::optional<Hit> nearest;
    for (int s = 0; s < scene.n_surfaces(); ++s) {
        const Surface &surface = scene.surface(SurfaceId(s));
        const double towards = surface.frame.normal.dot(direction);
        if (towards == 0)
            continue;
        const double t = -surface.frame.height(origin) / towards;
        if (t <= least || t >= most)
            continue;
        const Vec2 p = surface.frame.to_plane(origin + t * direction);
        if (!inside(surface.outline, p) || covered(surface, p))
            continue;
        most = t;
        nearest = Hit{s, t, towards < 0};
    }
    return nearest;
}

bool sees(const Scene &scene, const Vec3 &x, const Vec3 &y) { return !trace(scene, x, y - x, 1e-9, 1 - 1e-9); }

Vec3 cosine_direction(const PlaneFrame &frame, double a, double b) {
    const double radius = std::sqrt(a), angle = 2 * std::numbers::pi * b;
    return radius * std::cos(angle) * frame.u + radius * std::sin(angle) * frame.v + std::sqrt(1 - a) * frame.normal;
}

} // namespace penumbra::reference
