// VE and EV curves: planes through a corner and an edge, where they are real on the receiver.
#pragma once

#include "discontinuity/curve.h"
#include "discontinuity/sight_cells.h"
#include "discontinuity/source_view.h"
#include "scene/scene.h"

#include <vector>

namespace penumbra {

/// The curves of every corner and every edge of source and blockers that a line of sight can touch one behind the
/// other: VE where the corner is on the source's side, EV where the edge is. A line counts where no facet crosses it
/// and where what is seen about it changes its shape (local_picture.h). Order 1 where an edge through the corner is
/// aligned with the other edge and both bound what is seen, else 2.
void trace_corners(const Scene &scene, const SourceView &view, const SightCells &cells, std::vector<Curve> &curves);

} // namespace penumbra
