// EEE curves: lines that touch three edges, where they are real on the receiver.
#pragma once

#include "discontinuity/curve.h"
#include "discontinuity/source_view.h"
#include "scene/scene.h"

#include <vector>

namespace penumbra {

/// The curves of every edge of the source with two edges of blockers, and of every three edges of blockers, that a line
/// of sight can touch: arcs of conics (regulus.h), real where no facet crosses the line and what is seen about it
/// changes its shape (local_picture.h). Where two of the three lie in one plane the lines that touch all three pass
/// through the point where the third crosses it, and the curve is straight (kind VE or EV, order 1): edges that overlap
/// in the picture while the ends of both are hidden.
void trace_triples(const Scene &scene, const SourceView &view, std::vector<Curve> &curves);

} // namespace penumbra
