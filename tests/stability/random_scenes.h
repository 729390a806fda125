// Small scenes at random: what lights them, what stands in them and how it touches.
#pragma once

#include "core/options.h"
#include "reference/faces.h"

#include <cstdint>

namespace penumbra {

struct RandomScene {
    std::vector<reference::Face> faces;
    Options options; ///< threshold 0.05 or 0.02, any strategy, order 2 to 4
};

/// A closed room, walls with edges in common or a floor; one or two lamps, some of them in the ceiling's plane; up to
/// three of: polygons, slivers, boxes that stand on the floor or hang in the air, sheets that lie on the floor.
/// Reflectances up to 0.9. The same for the same seed on every machine.
RandomScene random_scene(std::uint32_t seed);

} // namespace penumbra
