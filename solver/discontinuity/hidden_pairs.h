// Pairs of surfaces that a third one hides from each other altogether: of many rooms most pairs stand in different ones,
// with a wall in between.
#pragma once

#include "scene/scene.h"

#include <Eigen/Geometry>

#include <atomic>
#include <vector>

namespace penumbra {

/// The bounding boxes of all surfaces.
std::vector<Eigen::AlignedBox3d> boxes_of(const Scene &scene);

class HiddenPairs {
public:
    explicit HiddenPairs(const Scene &scene);

    /// Whether one surface is proved to hide each of the two wholly from the other (source_view.h, hides). From many threads:
    /// which surface it finds may differ, the answer does not.
    bool hidden(SurfaceId source, SurfaceId receiver) const;

private:
    const Scene &scene_;
    std::vector<Eigen::AlignedBox3d> boxes_;
    std::vector<SurfaceId> large_first_;
    mutable std::vector<std::atomic<int>> last_; ///< by source: what hid the last receiver often hides the next
};

} // namespace penumbra
