// What a refinement did, one split at a time, so that it can be watched.
#pragma once

#include "core/ids.h"
#include "transport/interaction.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace penumbra {

/// A leaf that failed the oracle and was split.
struct SplitEvent {
    ElementId element;
    bool cut = false;             ///< along a line, not uniformly
    std::optional<CurveId> curve; ///< that the line follows; none: the best straight line (best_cut.h)
    SurfaceId source;             ///< whose light the element's fits miss most
    double misfit = 0;            ///< of that light, as a fraction of the peak; in the norm of allowance.h
    double threshold = 0;         ///< that it had to stay below
    std::vector<std::shared_ptr<const Interaction>> handed_down; ///< what failed there, and was linked anew to the pieces
    std::string sentence;         ///< all of this
};

/// A receiver that got new links.
struct LinkEvent {
    ElementId receiver;
    SurfaceId source;
    int n_links = 0;
};

/// Both in the order in which they happened; all splits come before all links. tests/agreement/split_events_test.cpp.
struct RefineEvents {
    std::vector<SplitEvent> splits;
    std::vector<LinkEvent> links;
};

} // namespace penumbra
