// Points, directions and colours of the solver, all in double precision.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace penumbra {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;

/// A spectrum of three channels (red, green, blue); products are channel by channel.
using Rgb = Eigen::Array3d;

/// z component of the cross product; twice the signed area of the triangle (0, a, b).
inline double cross(const Vec2 &a, const Vec2 &b) { return a.x() * b.y() - a.y() * b.x(); }

} // namespace penumbra
