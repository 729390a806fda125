// The error of the present state, independent of its links.
#pragma once

#include "iteration/state.h"
#include "measure/error_estimate.h"

namespace penumbra {

/// Residuals at fresh points (measure/residual.h), batch upon batch until the estimate's upper limit is within a factor of
/// sqrt(2) of it, or of sqrt(1.5) while it is below `goal` (a relative L2 error) and its limit is not; or until the upper limit
/// is far below the goal, or the lower one above it. At most 2^15 points.
/// Rays serve while their noise is below the residual; then the exact visible part of every element (reflected_gather.h).
/// K (I - K)^-1 r is one gather over the links of c = (I - A)^-1 mean r, constants on the surfaces (coarse_correction.h). What
/// of r varies within a surface is left out of it, which made the estimate 5 to 10 % low on cornell-box and next-room: with
/// more than one bounce `upper` is a tenth higher than the points' luck alone would make it.
ErrorEstimate measure_error(const Setting &setting, const State &state, double goal, std::uint64_t seed,
                            const Cancel *cancel, Work &work);

} // namespace penumbra
