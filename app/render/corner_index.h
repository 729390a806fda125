// The corners of one surface's patches, points that coincide taken as one: who meets where, and which corners lie in
// the middle of another patch's side.
#pragma once

#include "iteration/snapshot.h"

#include <span>
#include <unordered_map>
#include <vector>

namespace penumbra {

class CornerIndex {
public:
    /// `patches` are indices into snapshot.patches, all of one surface. Points nearer than 1e-8 of the patches' extent
    /// coincide.
    CornerIndex(const Snapshot &snapshot, std::span<const int> patches);

    int size() const { return static_cast<int>(points_.size()); }
    const Vec2 &point(int corner) const { return points_[static_cast<std::size_t>(corner)]; }
    /// Of the k-th of the patches.
    const std::vector<int> &corners_of(std::size_t k) const { return corners_[k]; }
    /// Corners strictly inside the segment between two corners, in order from the first.
    std::vector<int> between(int from, int to) const;

private:
    int merge(const Vec2 &p);
    std::int64_t bin(const Vec2 &p) const;
    void sort_into_bins();

    double slack_ = 0;
    Vec2 low_ = Vec2::Zero(), extent_ = Vec2::Zero();
    std::vector<Vec2> points_;
    std::vector<std::vector<int>> corners_;
    std::unordered_map<std::uint64_t, std::vector<int>> cells_; ///< of the size of the slack, for merging
    int n_bins_ = 1;                                            ///< along each axis
    std::vector<int> bin_start_, binned_;
};

} // namespace penumbra
