// Rays against the polygons of a scene, all of them, in double precision: no hierarchy, no tolerance but one.
#pragma once

#include "scene/scene.h"

#include <optional>
#include <random>

namespace penumbra::reference {

struct Hit {
    int surface;
    double t;   ///< the point is origin + t direction
    bool front; ///< met on its front
};

/// The nearest polygon that the ray meets for least < t < most. Coordinates are the solver's.
std::optional<Hit> trace(const Scene &scene, const Vec3 &origin, const Vec3 &direction, double least, double most);

/// Whether nothing stands between two points; what either point lies on does not count.
bool sees(const Scene &scene, const Vec3 &x, const Vec3 &y);

/// A direction about n with density cos / pi, from two numbers in [0,1).
Vec3 cosine_direction(const PlaneFrame &frame, double a, double b);

/// Whether the point lies in the simple polygon, by counting crossings.
bool inside(const std::vector<Vec2> &polygon, const Vec2 &p);

/// Whether another surface lies on this one there.
bool covered(const Surface &surface, const Vec2 &p);

} // namespace penumbra::reference
