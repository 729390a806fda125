// What the reflected light of a solution brings to a point.
#pragma once

#include "hierarchy/push_pull.h"
#include "transport/point_transfer.h"
#include "visibility/blockers.h"

#include <vector>

namespace penumbra {

/// The integral of G V (B_h - E) at points, each source element by its exact visible part: no links, no noise. An element
/// stands for its children where what it leaves out of them brings less than ten times `accuracy`, of the largest B_h - E;
/// an element's part is right to about `accuracy`: what is nearly even, or far away, gets moments of fewer digits, or its mean alone. Keeps references; may be asked from several threads.
class ReflectedGather {
public:
    ReflectedGather(const Scene &scene, const Blockers &blockers, const Forest &forest, Coefficients radiosity,
                   double accuracy = 1e-6);

    /// At a point of a surface's plane [W/m2].
    Rgb irradiance(SurfaceId surface, const Vec2 &point, Work &work) const;

private:
    const Scene &scene_;
    const Blockers &blockers_;
    const Forest &forest_;
    Coefficients reflected_;         ///< B_h - E
    double accuracy_;
    std::vector<double> detail_;     ///< dropped_detail, of the largest B_h - E
    std::vector<double> variation_;  ///< no less than what B_h - E leaves its mean by on an element, of the largest B_h - E
    std::vector<SourceNode> nodes_;  ///< by element
};

} // namespace penumbra
