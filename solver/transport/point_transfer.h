// What one receiver point gets from the nodes of a source.
#pragma once

#include "geometry/convex_pieces.h"
#include "hierarchy/forest.h"
#include "transport/interaction.h"

#include <span>
#include <vector>

namespace penumbra {

/// A source node, what of it is not covered, and how many of its coefficients can differ from 0 (of a surface that only
/// emits, one).
struct SourceNode {
    const Element &element;
    ConvexPieces whole;
    int n_columns;
};

/// Functions of q that a kernel of the full order has columns for: one where its radiosity is its exitance.
int n_columns(const Scene &scene, const Element &q);
SourceNode source_node(const Scene &scene, const Element &q);

/// T_j at receiver points, a block of columns for each source node. Under a flat cover of the receiver, which nothing
/// sees, T goes on as if it were not there: a hole with T = 0 would have to be fitted, and spoils upper levels. Under a
/// solid T is 0, as it is in the solid's own shadow.
class PointTransfer {
public:
    /// Of p and a source that were classified. Clips that its blockers spare are counted, too.
    PointTransfer(const Transport &transport, const Element &p, const Interaction &pair, std::vector<SourceNode> nodes,
                  Work &work);

    int n_columns() const { return n_columns_; }
    const std::vector<SourceNode> &nodes() const { return nodes_; }

    /// T_j at a point of p's plane: fills `row` (n_columns values). Looks at the cancel flag.
    void at(const Vec2 &point, std::span<double> row);

private:
    const Transport &transport_;
    const Surface &receiver_, &source_;
    std::span<const PairBlocker> clipping_;
    int n_clips_of_all_;
    std::vector<SourceNode> nodes_;
    Work &work_;
    VisibleScratch scratch_;
    int n_columns_ = 0;
};

} // namespace penumbra
