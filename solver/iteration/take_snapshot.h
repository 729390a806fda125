// From the solver's state to plain arrays.
#pragma once

#include "iteration/state.h"

namespace penumbra {

/// Everything but the error.
std::shared_ptr<Snapshot> take_snapshot(const Setting &setting, const State &state);

/// The curves as polylines in the scene's own frame.
std::shared_ptr<const std::vector<SnapshotCurve>> draw_curves(const Setting &setting);

} // namespace penumbra
