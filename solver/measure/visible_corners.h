// Corners of a region that is given as disjoint convex pieces.
#pragma once

#include "geometry/convex_pieces.h"

#include <vector>

namespace penumbra {

/// Points where the border of the pieces' union turns. Where pieces merely meet there is none. Points nearer to each
/// other than `slack` (a length) are one.
std::vector<Vec2> corners_of_union(const ConvexPieces &pieces, double slack);

} // namespace penumbra
