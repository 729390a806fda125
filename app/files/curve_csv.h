// Curve files: `curve,kind,order,source,receiver,x,y,z,blockers`.
#pragma once

#include "iteration/snapshot.h"

#include <string>
#include <vector>

namespace penumbra {

/// Consecutive rows of one curve are its polyline, in the scene's own frame; numbers are written so that they read back
/// to the same bits.
std::string curve_csv(const std::vector<SnapshotCurve> &curves);

} // namespace penumbra
