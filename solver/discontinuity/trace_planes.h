// Plane curves: where the source, or a blocker in front of it, is seen edge-on (order 1).
#pragma once

#include "discontinuity/curve.h"
#include "discontinuity/sight_cells.h"
#include "discontinuity/source_view.h"
#include "scene/scene.h"

#include <vector>

namespace penumbra {

/// The source's own plane cut with the receiver, where any of the source would be seen along it; and every blocker's
/// plane, where a sight line in it passes the blocker, is not blocked by another, and meets the source.
void trace_planes(const Scene &scene, const SourceView &view, const SightCells &cells, std::vector<Curve> &curves);

} // namespace penumbra
