// From the solver's state to plain arrays.
#pragma once

#include "iteration/state.h"

namespace penumbra {

/// Everything but the error.
std::shared_ptr<Snapshot> take_snapshot(const Setting &setting, const State &state);

/// A curve as a polyline in the scene's own frame.
SnapshotCurve draw_curve(const Scene &scene, const Curve &curve);

} // namespace penumbra
