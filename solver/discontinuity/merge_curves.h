// Critical surfaces that coincide throw one curve.
#pragma once

#include "discontinuity/curve.h"

#include <vector>

namespace penumbra {

/// Joins curves of one source on one receiver that lie in line and overlap or touch: where the orders differ, the lower
/// one stays (a jump of the slope hides one of the curvature) and the other keeps the rest of its length; plane curves
/// give way to VE and EV of the same order. Blockers are united. Arcs stay as they are, but one that repeats another is
/// dropped. Deterministic; curves of different pairs stay apart.
std::vector<Curve> merge_curves(const std::vector<Curve> &curves);

/// Whether the two segments lie in one line, to within twice the coincidence of points.
bool in_line(const Curve &a, const Curve &b);

} // namespace penumbra
