// VE curves of a source that sinks below the receiver's horizon: lines of sight within the receiver's own plane.
#pragma once

#include "discontinuity/curve.h"
#include "discontinuity/source_view.h"
#include "scene/scene.h"

#include <vector>

namespace penumbra {

/// Where the source's outline passes through the receiver's plane it has a corner on the horizon. A blocker that stands
/// on or pierces the receiver hides it behind the ends of its foot: rays from the corner over these ends, up to what
/// crosses them. Order 2 (light at the horizon adds no irradiance).
void trace_horizon(const Scene &scene, const SourceView &view, std::vector<Curve> &curves);

} // namespace penumbra
