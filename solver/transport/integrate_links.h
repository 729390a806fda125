// The coefficients of a pair's links.
#pragma once

#include "transport/interaction.h"

#include <span>

namespace penumbra {

/// Fills `out`, a pair that was classified (all but order and links), with links to `sources`; see `connect`. `distance`:
/// corner_distance of the two.
void integrate_links(const Transport &transport, const Forest &forest, Interaction &out,
                     std::span<const ElementId> sources, const Leeway &leeway, double distance,
                     const Interaction *before, Work &work);

} // namespace penumbra
