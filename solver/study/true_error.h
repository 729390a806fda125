// How wrong a solution really is, where the truth can be had.
#pragma once

#include "iteration/state.h"

#include <functional>
#include <memory>

namespace penumbra {

/// ||B_h - B|| / ||B - E|| in L2 over all reflecting surfaces and the three channels together, B the truth. A state is
/// looked at after a complete iteration.
using TrueError = std::function<double(const State &)>;

/// Against the exact direct solution (measure/direct.h). Empty where light is reflected more than once: that takes a
/// reference solution.
TrueError error_against_direct_light(const std::shared_ptr<const Scene> &scene);

} // namespace penumbra
