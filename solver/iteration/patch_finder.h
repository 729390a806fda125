// Which patch of a snapshot holds a point, found by a grid over each surface.
#pragma once

#include "iteration/snapshot.h"

#include <memory>
#include <vector>

namespace penumbra {

/// Immutable once made; may be asked from several threads.
class PatchFinder {
public:
    explicit PatchFinder(std::shared_ptr<const Snapshot> snapshot);

    /// Null where the surface has none: beyond its outline, or under a cover. On a side that two patches share, to a billionth
    /// of the surface's size, either of them. `point`: of the surface's plane.
    const SnapshotPatch *patch_at(int surface, const Vec2 &point) const;
    const Snapshot &snapshot() const { return *snapshot_; }

private:
    /// n x n cells over the surface, row after row, each with the patches that reach into it.
    struct Grid {
        int n = 0; ///< 0: the surface has no patch
        Vec2 low = Vec2::Zero(), size = Vec2::Zero();
        double slack = 0;
        std::vector<std::vector<const SnapshotPatch *>> cells;

        int column(double x) const;
        int row(double y) const;
    };

    std::shared_ptr<const Snapshot> snapshot_;
    std::vector<Grid> grids_; ///< by surface
};

} // namespace penumbra
