// Drawings of the discontinuity curves, a receiver each.
#pragma once

#include "files/curve_arrangement.h"
#include "iteration/snapshot.h"

#include <string>
#include <utility>

namespace penumbra {

/// File name and SVG text: the surface seen from its front, its regions in quiet tints (no two neighbours in the same),
/// the curves coloured by kind and drawn by order (0 thick, 1 plain, 2 dashed), and a legend of the kinds that occur.
std::pair<std::string, std::string> curve_drawing(const Snapshot &snapshot, const ReceiverCurves &curves);

} // namespace penumbra
