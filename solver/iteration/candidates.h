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

/// Candidates: every curve of a failing source that crosses the node (strategies that cut), and the uniform split, if the
/// depth limit allows it. Each is scored by least squares on samples of what the failing sources bring; with one
/// candidate nothing is sampled. None when nothing is allowed.
std::optional<Split> best_split(const Setting &setting, const Transport &transport, const State &state, ElementId node,
                                std::span<const Interaction *const> failing, Work &work);

} // namespace penumbra
