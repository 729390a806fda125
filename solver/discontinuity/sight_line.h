// One line of sight.
#pragma once

#include "core/vec.h"

namespace penumbra {

/// From a point of the receiver towards the source.
struct SightLine {
    Vec3 from, along; ///< along is unit

    Vec3 at(double distance) const { return from + distance * along; }
};

} // namespace penumbra
