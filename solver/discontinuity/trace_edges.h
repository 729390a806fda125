// Curves of two edges in one plane, where one is seen behind the other.
#pragma once

#include "discontinuity/curve.h"
#include "discontinuity/sight_cells.h"
#include "discontinuity/source_view.h"
#include "scene/scene.h"

#include <vector>

namespace penumbra {

/// Where their plane meets the receiver and some line of sight touches both edges between their ends with the strip
/// between them closing (local_picture.h): a slit whose ends are hidden, slats that close. VE of order 1, like the curves
/// of the edges' corners, which lie in line with them.
void trace_edges(const Scene &scene, const SourceView &view, const SightCells &cells, std::vector<Curve> &curves);

} // namespace penumbra
