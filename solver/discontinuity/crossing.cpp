#include "discontinuity/crossing.h"

#include <cmath>

namespace penumbra {

void Crossing::add(const Vec3 &x, const Vec3 &direction) {
    if (n == 0)
        p = q = x;
    else if ((x - p).dot(direction) < 0)
        p = x;
    else if ((x - q).dot(direction) > 0)
        q = x;
    ++n;
}

Crossing cross_facet(const Wedge &wedge, const Facet &facet) {
    Crossing crossing;
    const Vec3 direction = wedge.normal.cross(facet.frame.normal);
    const std::size_t n = facet.corners.size();
    int previous = wedge.side(facet.corners[n - 1]);
    for (std::size_t i = 0; i < n; ++i) {
        const Vec3 &corner = facet.corners[i];
        const int side = wedge.side(corner);
        crossing.left |= side > 0;
        crossing.right |= side < 0;
        if (side == 0) {
            crossing.add(corner, direction);
        } else if (side * previous < 0) {
            const Vec3 &before = facet.corners[(i + n - 1) % n];
            const double h = std::abs(wedge.height(corner)), h_before = std::abs(wedge.height(before));
            crossing.add(before + h_before / (h + h_before) * (corner - before), direction);
        }
        previous = side;
    }
    return crossing;
}

} // namespace penumbra
