#include "iteration/patch_finder.h"

#include "geometry/polygon.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace penumbra {

namespace {

constexpr int most_cells = 256; ///< to a side

int cell(double offset, double size, int n) {
    return size > 0 ? std::clamp(static_cast<int>(std::floor(offset / size * n)), 0, n - 1) : 0;
}

/// How far it lies beyond the sides of a convex polygon; 0 inside.
double outside(const std::vector<Vec2> &corners, const Vec2 &p) {
    double most = 0;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const Vec2 &a = corners[k], side = corners[(k + 1) % corners.size()] - a;
        if (side.norm() > 0)
            most = std::max(most, -cross(side, p - a) / side.norm());
    }
    return most;
}

} // namespace

int PatchFinder::Grid::column(double x) const { return cell(x - low.x(), size.x(), n); }
int PatchFinder::Grid::row(double y) const { return cell(y - low.y(), size.y(), n); }

PatchFinder::PatchFinder(std::shared_ptr<const Snapshot> snapshot)
    : snapshot_(std::move(snapshot)), grids_(snapshot_->surfaces.size()) {
    std::vector<int> n_patches(grids_.size());
    for (const SnapshotPatch &patch : snapshot_->patches)
        ++n_patches[static_cast<std::size_t>(patch.surface)];
    for (std::size_t s = 0; s < grids_.size(); ++s) {
        Grid &grid = grids_[s];
        const std::vector<Vec2> &outline = snapshot_->surfaces[s].outline;
        if (n_patches[s] == 0 || outline.empty())
            continue;
        Vec2 high = grid.low = outline.front();
        for (const Vec2 &p : outline) {
            grid.low = grid.low.cwiseMin(p);
            high = high.cwiseMax(p);
        }
        grid.size = high - grid.low;
        grid.slack = 1e-9 * grid.size.norm();
        grid.n = std::clamp(static_cast<int>(std::ceil(std::sqrt(n_patches[s]))), 1, most_cells);
        grid.cells.resize(static_cast<std::size_t>(grid.n) * static_cast<std::size_t>(grid.n));
    }
    for (const SnapshotPatch &patch : snapshot_->patches) {
        Grid &grid = grids_[static_cast<std::size_t>(patch.surface)];
        if (grid.n == 0 || patch.corners.empty())
            continue;
        Vec2 low = patch.corners.front(), high = low;
        for (const Vec2 &p : patch.corners) {
            low = low.cwiseMin(p);
            high = high.cwiseMax(p);
        }
        for (int row = grid.row(low.y() - grid.slack); row <= grid.row(high.y() + grid.slack); ++row)
            for (int column = grid.column(low.x() - grid.slack); column <= grid.column(high.x() + grid.slack); ++column)
                grid.cells[static_cast<std::size_t>(row * grid.n + column)].push_back(&patch);
    }
}

const SnapshotPatch *PatchFinder::patch_at(int surface, const Vec2 &point) const {
    const Grid &grid = grids_[static_cast<std::size_t>(surface)];
    if (grid.n == 0)
        return nullptr;
    const SnapshotPatch *best = nullptr;
    double nearest = std::numeric_limits<double>::infinity();
    for (const SnapshotPatch *patch : grid.cells[static_cast<std::size_t>(grid.row(point.y()) * grid.n + grid.column(point.x()))])
        if (const double off = outside(patch->corners, point); off <= grid.slack && off < nearest) {
            nearest = off;
            best = patch;
        }
    return best;
}

} // namespace penumbra
