// Form factors known in closed form (Howell, A Catalog of Radiation Heat Transfer Configuration Factors).
#pragma once

#include "core/vec.h"

#include <cmath>
#include <numbers>

namespace penumbra::reference {

/// Two equal parallel rectangles a x b, face to face at distance c (Howell C-11; Hottel 1931).
inline double parallel_rectangles(double a, double b, double c) {
    const double x = a / c, y = b / c, x2 = 1 + x * x, y2 = 1 + y * y;
    return 2 / (std::numbers::pi * x * y) *
           (std::log(x2 * y2 / (x2 + y * y)) / 2 + x * std::sqrt(y2) * std::atan(x / std::sqrt(y2)) +
            y * std::sqrt(x2) * std::atan(y / std::sqrt(x2)) - x * std::atan(x) - y * std::atan(y));
}

/// From a rectangle `length` x `depth` to one `length` x `height` that stands on its longer side at a right angle
/// (Howell C-14; Hamilton & Morgan 1952).
inline double perpendicular_rectangles(double length, double depth, double height) {
    const double w = depth / length, h = height / length;
    const double w2 = w * w, h2 = h * h, s = w2 + h2;
    const double logarithm = std::log((1 + w2) * (1 + h2) / (1 + s)) + w2 * std::log(w2 * (1 + s) / ((1 + w2) * s)) +
                             h2 * std::log(h2 * (1 + s) / ((1 + h2) * s));
    return (w * std::atan(1 / w) + h * std::atan(1 / h) - std::sqrt(s) * std::atan(1 / std::sqrt(s)) + logarithm / 4) /
           (std::numbers::pi * w);
}

/// Irradiance vector of a unit-radiosity rectangle [0,a] x [0,b] at height c above the point 0, in front of it: its
/// product with the receiver's unit normal n is the form factor of the point, as long as all of the rectangle is in
/// front of the receiver's plane. The components are the point factors of a parallel (Howell B-3) and of two
/// perpendicular rectangles (B-4).
inline Vec3 rectangle_over_corner(double a, double b, double c) {
    const double x = a / c, y = b / c;
    const double across = x / std::sqrt(1 + x * x) * std::atan(y / std::sqrt(1 + x * x)) +
                          y / std::sqrt(1 + y * y) * std::atan(x / std::sqrt(1 + y * y));
    // Of a receiver that faces along an axis: what the strip to infinity gives less what is beyond the far side.
    const auto sideways = [&](double wide, double deep) {
        return std::atan(wide) - std::atan(wide / std::sqrt(1 + deep * deep)) / std::sqrt(1 + deep * deep);
    };
    return Vec3(sideways(y, x), sideways(x, y), across) / (2 * std::numbers::pi);
}

/// The same for any rectangle [x0,x1] x [y0,y1] at height c, by adding and taking away corners.
inline Vec3 rectangle_overhead(double x0, double x1, double y0, double y1, double c) {
    const auto corner = [&](double x, double y) {
        const Vec3 v = rectangle_over_corner(std::abs(x), std::abs(y), c);
        // A part on the other side of an axis mirrors the component along it; the product of signs makes it a signed
        // area.
        return Vec3(std::copysign(1.0, y) * v.x(), std::copysign(1.0, x) * v.y(),
                    std::copysign(1.0, x) * std::copysign(1.0, y) * v.z());
    };
    return corner(x1, y1) - corner(x0, y1) - corner(x1, y0) + corner(x0, y0);
}

} // namespace penumbra::reference
