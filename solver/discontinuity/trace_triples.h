// EEE curves: lines that touch three edges, where they are real on the receiver.
#pragma once

#include "discontinuity/curve.h"
#include "discontinuity/sight_cells.h"
#include "discontinuity/source_view.h"
#include "scene/scene.h"

#include <vector>

namespace penumbra {

/// The curves of every edge of the source with two edges of blockers, and of every three edges of blockers, that a line
/// of sight can touch: arcs of conics (regulus.h), real where no facet crosses the line and what is seen about it
/// changes its shape (local_picture.h). Edges of which two lie in
/// one plane throw none.
void trace_triples(const Scene &scene, const SourceView &view, const SightCells &cells, std::vector<Curve> &curves);

} // namespace penumbra
