// Polylines cut at their crossings, with near points made one, before anything exact is asked.
#pragma once

#include "core/vec.h"

#include <span>
#include <vector>

namespace penumbra {

/// A straight piece between two points, and the lines (ascending) that it is part of.
struct SnappedPiece {
    int from = 0, to = 0; ///< from < to
    std::vector<int> lines;
};

struct SnappedLines {
    std::vector<Vec2> points;
    std::vector<SnappedPiece> pieces; ///< no two between the same points
};

/// Cuts the polylines where they meet each other. Points within `snap` of each other become the first of them (corners
/// and ends in the lines' order, then crossings), and a line within `snap` of such a point goes through it. In double
/// precision: pieces may still cross, by about `snap`, where many crossings lie as near to each other.
SnappedLines snap_lines(std::span<const std::vector<Vec2>> lines, double snap);

} // namespace penumbra
