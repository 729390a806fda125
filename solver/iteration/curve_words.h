// A discontinuity curve by what throws it, in words.
#pragma once

#include "iteration/snapshot.h"

#include <functional>
#include <string>
#include <vector>

namespace penumbra {

/// "a", "a and b", "a, b and c"; each name once.
std::string listed(const std::vector<std::string> &names);

/// Of the edges that the curve's lines of sight touch the first corner, or the first true edge; null where there is none.
const SnapshotEdge *touched(const SnapshotCurve &curve, bool corner);

/// "EV curve of an edge of lamp and a corner of table": what is on the source's side first. `name` gives that of a surface.
std::string curve_words(const SnapshotCurve &curve, const std::function<std::string(int)> &name);

} // namespace penumbra
