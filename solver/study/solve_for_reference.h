// The solution that a reference gathers from.
#pragma once

#include "measure/reference.h"

#include <functional>
#include <memory>

namespace penumbra {

/// Is told after each iteration of the solution.
using ReferenceProgress = std::function<void(const Counters &)>;

/// Solves the scene to the tolerance, in the parametric basis with cuts; where that is out of reach, as far as it goes.
/// The error of the reference that this makes is what a further bounce of the solution's residual brings (the `bounced`
/// of measure/error_estimate.h): mostly a tenth to a third of the tolerance.
ConvergedSolution solve_for_reference(const std::shared_ptr<const Scene> &scene, double tolerance,
                                      const Cancel *cancel = nullptr, const ReferenceProgress &told = {});

} // namespace penumbra
