// Triangles of a simple polygon.
#pragma once

#include "geometry/polygon.h"

#include <array>

namespace penumbra {

/// Indices of corners, counter-clockwise, of the triangles that tile a simple counter-clockwise polygon: n - 2 of them
/// (Meisters 1975, "Polygons have ears"). Takes the ear with the largest smallest angle first. O(n^3) at worst.
std::vector<std::array<int, 3>> cut_ears(const Polygon &polygon);

} // namespace penumbra
