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

/// Why a pair was linked.
enum class LinkReason {
    new_pair,          ///< the source has come to shine
    handed_down,       ///< links of an element above have failed
    order_too_low,     ///< what it brings has come to matter more than the order lets through
    too_bright,        ///< for the constant that served
    source_too_coarse, ///< detail of the source has come to matter
    limit              ///< it failed where nothing can be split: it is fitted as well as can be
};

/// An element and a surface that were linked anew.
struct LinkEvent {
    LinkReason reason = LinkReason::new_pair;
    std::shared_ptr<const Interaction> made; ///< without links where nothing gets through
    /// What it took the place of, of the same element or, among its parts first come, of one above that was not split in this
    /// refinement; null: nothing, or what a split has handed down.
    std::shared_ptr<const Interaction> replaced;
};

/// Both in the order in which they happened; all splits come before all links. tests/agreement/split_events_test.cpp.
struct RefineEvents {
    std::vector<SplitEvent> splits;
    std::vector<LinkEvent> links;
};

} // namespace penumbra
