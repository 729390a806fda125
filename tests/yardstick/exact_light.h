// Direct light on one surface, exact at every point, and its integrals where a blocker that stands on it makes it jump.
#pragma once

#include "geometry/polygon.h"
#include "hierarchy/push_pull.h"
#include "visibility/blockers.h"

#include <span>
#include <utility>
#include <vector>

namespace penumbra::yardstick {

/// A quadrature point in the surface's plane, its weight in dA, and the exact reflected radiosity B - E there.
struct Sample {
    Vec2 position;
    double area = 0;
    Rgb value = Rgb::Zero();
};

/// The exact reflected radiosity of one surface (measure/direct.h), dark where it is covered. It jumps across the edges
/// of other surfaces that lie in the plane (contact); these are taken from the scene's corners, not from curves.
class ExactLight {
public:
    ExactLight(const Scene &scene, SurfaceId surface);

    /// Samples over a convex polygon that is first split along the edges in contact; every piece gets n x n Gauss
    /// points of its quads and triangles. Between jumps the light is continuous, with kinks where penumbras begin and
    /// end: sums over one piece converge as kinks let them (yardstick_test.cpp bounds what is left).
    std::vector<Sample> samples(const Polygon &convex, int n) const;
    SurfaceId surface() const { return surface_; }

private:
    const Scene &scene_;
    SurfaceId surface_;
    Blockers blockers_;
    std::vector<std::pair<Vec2, Vec2>> contacts_;
};

/// ||B_h - B|| / ||B - E|| in L2 over the whole surface and all channels, B_h the solution whose coefficients these
/// are. Unlike measure/direct.h it counts what is covered, where B is 0: a shadow's sharp edge lies there.
double relative_error(const ExactLight &exact, const Forest &forest, const Coefficients &radiosity,
                      const Rgb &exitance);

} // namespace penumbra::yardstick
