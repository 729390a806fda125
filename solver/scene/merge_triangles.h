// From the triangles that meshes are exported as back to the polygons that were modelled.
#pragma once

#include "core/vec.h"

#include <array>
#include <span>
#include <vector>

namespace penumbra {

struct MeshTriangle {
    std::array<int, 3> corners; ///< indices of points, counter-clockwise seen from the front
    int material = 0;
};

struct MergedFace {
    std::vector<int> corners;
    int material = 0;
    int first = 0; ///< its first triangle
};

/// Merges triangles that share an edge and a material and lie in one plane, to within the rounding of single precision
/// of the largest coordinate, into simple polygons of at most about `most_corners` corners, concave ones too; never
/// into a polygon with a hole, or one that touches itself: what would close a ring starts a polygon of its own. A
/// triangle without area, one at an edge that more than two share, and those of a polygon that would not be flat or
/// simple stay as they are. Points must be distinct. In the order of each polygon's first triangle.
std::vector<MergedFace> merge_triangles(std::span<const Vec3> points, std::span<const MeshTriangle> triangles);

} // namespace penumbra
