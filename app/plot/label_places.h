// Where labels go, so that each stands beside its curve and on nothing else.
#pragma once

#include "plot/canvas.h"

#include <vector>

namespace penumbra {

/// A label that may stand beside any of its anchors.
struct LabelWish {
    std::vector<glm::vec2> anchors; ///< the best one last
    float width = 0;                ///< 0: no label
};

/// Boxes for labels of height `height`, in the order of the wishes, inside `box`; `taken` are points that are better left
/// free. Wishes are served one after the other: what costs least is taken, another label's place costing most, then
/// points that would be covered, then distance along the curve from the best anchor.
std::vector<PlotBox> place_labels(const PlotBox &box, const std::vector<LabelWish> &wishes,
                                  const std::vector<glm::vec2> &taken, float height);

} // namespace penumbra
