// The truth about a scene, as far as it can be had.
#pragma once

#include "core/cancel.h"
#include "core/counters.h"
#include "measure/reference.h"
#include "scene/scene.h"

#include <functional>
#include <memory>

namespace penumbra {

/// Where light bounces once: exact, at once. Else the scene is solved to this tolerance, in the planar basis with
/// curves and cubics, and gathered anew at each point asked for: the error is what a bounce leaves of the solution's.
/// `told` is called after each iteration. Throws Cancelled.
std::shared_ptr<const Reference> find_reference(const std::shared_ptr<const Scene> &scene, double tolerance,
                                                const Cancel *cancel = nullptr,
                                                const std::function<void(const Counters &)> &told = {});

/// Of references for pictures.
inline constexpr double picture_tolerance = 0.01;

} // namespace penumbra
