// Convex polygons cut in two, in their own frames.
#pragma once

#include "basis/planar_element.h"
#include "geometry/convex_pieces.h"
#include "hierarchy/side.h"

#include <array>
#include <optional>
#include <vector>

namespace penumbra {

struct PlanarPiece {
    PlanarDomain domain;
    std::vector<SideKind> sides; ///< of the polygon's sides, side k from corner k to the next
};

/// The two parts of the domain on either side of the line h = 0 of its own frame, the inside (h > 0) first, with
/// `new_side` along the line. Corners nearer to the line than 1e-6 of the frame's unit are on it (counted in
/// `n_snapped`). None when the line misses the polygon or leaves a part narrower than 1e-6 of the frame.
std::optional<std::array<PlanarPiece, 2>> split(const PlanarDomain &domain, const std::vector<SideKind> &sides,
                                                const HalfPlane &line, SideKind new_side, int &n_snapped);

/// The halves across the longer side of the domain's box in the plane. They tile it exactly.
std::array<PlanarPiece, 2> bisected(const PlanarDomain &domain, const std::vector<SideKind> &sides);

/// A line of the plane in the domain's own frame.
HalfPlane in_own_frame(const PlanarDomain &domain, const HalfPlane &line);

} // namespace penumbra
