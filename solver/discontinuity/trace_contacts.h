// Contact curves: where a blocker touches or pierces the receiver, and the borders of what lies on it (order 0).
#pragma once

#include "discontinuity/curve.h"
#include "discontinuity/sight_cells.h"
#include "discontinuity/source_view.h"
#include "scene/scene.h"

#include <vector>

namespace penumbra {

/// Real where at least one of the two sides sees something of the source. What a side sees changes along the contact
/// only where it crosses another curve, so `curves` must hold those of this source and receiver already.
void trace_contacts(const Scene &scene, const SourceView &view, const SightCells &cells, std::vector<Curve> &curves);

} // namespace penumbra
