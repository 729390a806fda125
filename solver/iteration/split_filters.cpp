#include "iteration/split_filters.h"

namespace penumbra {

std::vector<int> splits_above(const Snapshot &snapshot, int patch) {
    std::vector<int> above;
    for (int s = snapshot.patches[static_cast<std::size_t>(patch)].place.split; s >= 0;
         s = snapshot.splits[static_cast<std::size_t>(s)].place.split)
        above.push_back(s);
    return above;
}

SplitFilters split_filters(const Snapshot &snapshot, int split) {
    const SnapshotSplit &from = snapshot.splits[static_cast<std::size_t>(split)];
    SplitFilters out{from.surface, from.kind, snapshot.options.basis, snapshot.options.effective_order(), from.corners,
                     {},           {}};
    const Eigen::Index n = from.pieces.front().filters->pull.rows();
    out.loss = -Eigen::MatrixXd::Identity(n, n);
    for (const SnapshotPiece &piece : from.pieces) {
        const auto &[push, pull] = *piece.filters;
        const double share = pull(0, 0); // N_0 = 1 in both families: what the piece has of the element's measure
        out.pieces.push_back({piece.corners, share, push, pull, pull - share * push.transpose()});
        out.loss += pull * push;
    }
    return out;
}

std::array<int, 2> function_degrees(BasisFamily basis, int order, int k) {
    if (basis == BasisFamily::parametric)
        return {k / order, k % order};
    int degree = 0;
    while (k > degree)
        k -= ++degree;
    return {degree - k, k};
}

} // namespace penumbra
