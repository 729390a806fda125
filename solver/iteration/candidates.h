// How a failing node could be split, and which way pays best.
#pragma once

#include "hierarchy/cut.h"
#include "iteration/state.h"

#include <optional>
#include <span>

namespace penumbra {

/// A way to split one node: the uniform split, or a cut.
struct Split {
    std::optional<CutPlan> cut; ///< none: uniform
    std::optional<CurveId> curve;
    double score = 0; ///< squared error removed per coefficient added [(W/m2)^2]
};

/// Candidates, in strategies that cut, are the curves of the failing sources that cross the node and are worth it
/// (Options::least_gain of `allowed`, the misfit [W/m2] that passes); where there is none and Options::cut asks for it,
/// the best straight cut; and, if the depth limit allows it, the uniform split. They are scored by least squares on
/// samples of what the failing sources bring; with one candidate nothing is sampled. None when nothing is allowed or
/// worth it. What was snapped and left out is counted in `work`, once for a node that is kept.
std::optional<Split> best_split(const Setting &setting, const Transport &transport, const State &state, ElementId node,
                                std::span<const Interaction *const> failing, double allowed, Work &work);

} // namespace penumbra
