// The coefficients of a pair's links.
#pragma once

#include "transport/interaction.h"

#include <span>
#include <vector>

namespace penumbra {

/// Where the oracle tests the fit of a pair that was classified: a grid (receiver_points.h), where shadows fall and things
/// stand (shadow_points.h), and where a small source lights most (lit_points.h). A link's misfits have a row for each.
/// `distance`: corner_distance of the two.
std::vector<Vec2> oracle_points(const Transport &transport, const Element &p, const Interaction &pair, double distance);

/// Fills `out`, a pair that was classified (all but order and links), with links to `sources`; see `connect`. `distance`:
/// corner_distance of the two.
void integrate_links(const Transport &transport, const Forest &forest, Interaction &out,
                     std::span<const ElementId> sources, const Leeway &leeway, double distance,
                     const Interaction *before, Work &work);

} // namespace penumbra
