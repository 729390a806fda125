// The paper's outlook: a cut where no discontinuity curve helps.
#pragma once

#include "hierarchy/cut.h"
#include "iteration/sampled_field.h"

#include <optional>

namespace penumbra {

/// The straight cut across the node after which fits to the field have the least squared error for the coefficients
/// that it adds (the choice of a split plane by Campbell & Fussell 1990, with polynomials in place of constants): the
/// best line through points at eighths of two sides, moved along them by ever smaller steps down to a thirty-second.
/// None when no line lowers the error. Deterministic. The cut counts as a bisection: half a depth.
std::optional<CutPlan> best_cut(const Element &node, const SampledField &field);

} // namespace penumbra
