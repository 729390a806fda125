// Drawings of the discontinuity curves, a receiver each.
#pragma once

#include "iteration/snapshot.h"

#include <string>
#include <utility>
#include <vector>

namespace penumbra {

/// File name and SVG text for each surface that receives curves: its outline seen from its front, the curves coloured by
/// kind and drawn by order (0 thick, 1 plain, 2 dashed), and a legend of the kinds that occur.
std::vector<std::pair<std::string, std::string>> curve_drawings(const Snapshot &snapshot);

} // namespace penumbra
