// VE and EV curves: planes through a corner and an edge, where they are real on the receiver.
#pragma once

#include "discontinuity/curve.h"
#include "discontinuity/source_view.h"
#include "scene/scene.h"

#include <vector>

namespace penumbra {

/// The curves that a corner of the source throws over an edge of a blocker (VE), and an edge of the source over a
/// corner of a blocker (EV). A sight line counts where no facet crosses it, where the blocker's edge (or corner) is on
/// the silhouette there, and where something of the source about its end is seen. Order 1 where an edge of the source
/// and one of the blocker lie in the wedge's plane together, else 2.
void trace_source_corners(const Scene &scene, const SourceView &view, std::vector<Curve> &curves);
void trace_source_edges(const Scene &scene, const SourceView &view, std::vector<Curve> &curves);

} // namespace penumbra
