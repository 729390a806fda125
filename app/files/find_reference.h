// The reference of a scene: at hand, kept from before, or made.
#pragma once

#include "study/solve_for_reference.h"

namespace penumbra {

/// Where light bounces once, at once. Else from a solution to `tolerance` or finer that is kept in the cache folder, or
/// from one that is solved for now and then kept (no folder to keep it in is no error). Throws Cancelled.
std::shared_ptr<const Reference> find_reference(const std::shared_ptr<const Scene> &scene, double tolerance,
                                                const Cancel *cancel, const ReferenceProgress &told = {});

/// Of references for pictures.
inline constexpr double picture_tolerance = 0.003;

} // namespace penumbra
