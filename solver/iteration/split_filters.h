// The filters of one split of a solution, and what becomes of the paper's relation between them.
#pragma once

#include "iteration/snapshot.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace penumbra {

/// Between an element that was split and one of its pieces: b_piece = push b_element (Bouatouch & Pattanaik 1995, (6)),
/// b_element = sum over the pieces of pull b_piece (7).
struct PieceFilters {
    std::vector<Vec2> corners; ///< in the surface's frame, scene's own length unit
    double share = 0; ///< C: of the element's area (planar), of its parameter square (parametric: the mean of A(u',v'))
    Eigen::MatrixXd push; ///< functions of the piece x functions of the element
    Eigen::MatrixXd pull; ///< functions of the element x functions of the piece
    /// pull - C push^T: 0 in the planar basis for every split, in the parametric one where A(u',v') is constant, as for
    /// uniform dilation (below (7)). To rounding.
    Eigen::MatrixXd difference;
};

struct SplitFilters {
    int surface = 0;
    SplitKind kind = SplitKind::uniform;
    BasisFamily basis = BasisFamily::parametric;
    int order = 1;
    std::vector<Vec2> corners; ///< of the element
    std::vector<PieceFilters> pieces;
    /// Sum of pull push over the pieces, less the identity: what a round trip down and up changes. Planar: 0.
    Eigen::MatrixXd loss;
};

/// The splits of snapshot.splits that led to the patch, the last one first; none where the patch is a root.
std::vector<int> splits_above(const Snapshot &snapshot, int patch);
/// tests/identity/split_filters_test.cpp integrates them anew from the two bases' functions.
SplitFilters split_filters(const Snapshot &snapshot, int split);

/// Degrees of function k: of its two Legendre polynomials, in u and in v (parametric); of its highest power of the one
/// and of the other coordinate of the element's box (planar). The numbering of ElementBasis.
std::array<int, 2> function_degrees(BasisFamily basis, int order, int k);

} // namespace penumbra
