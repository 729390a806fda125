// How wrong a solution really is, where the truth can be had.
#pragma once

#include "iteration/state.h"
#include "measure/reference.h"

#include <functional>
#include <memory>

namespace penumbra {

/// ||B_h - B|| / ||B - E|| in L2 over all reflecting surfaces and the three channels together, B the truth. A state is
/// looked at after a complete iteration.
using TrueError = std::function<double(const State &)>;

/// Against the exact direct solution on a grid (measure/direct.h) where light bounces once, else against the reference
/// at 4096 random points of each state's own (measure/reference.h).
TrueError error_against(std::shared_ptr<const Scene> scene, std::shared_ptr<const Reference> reference);

} // namespace penumbra
