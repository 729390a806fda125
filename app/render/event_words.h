// What happens at a discontinuity curve, in words.
#pragma once

#include "iteration/snapshot.h"

#include <string>

namespace penumbra {

struct EventWords {
    std::string sentence; ///< "Crossing this line, a corner of light goes behind an edge of box."
    std::string jump;     ///< "Across it the curvature of the irradiance jumps."
    std::string symbol;   ///< "VE, D²"
    std::string way;      ///< "light → floor, past box"
};
EventWords event_words(const Snapshot &snapshot, const SnapshotCurve &curve);

/// What has just happened to a point of the receiver that crossed the curve and is now at `here`: the sentence is "A
/// corner of light went behind an edge of box.", the jump empty.
EventWords crossing_words(const Snapshot &snapshot, const SnapshotCurve &curve, const Vec3 &here);

/// A surface's name in a sentence: that of its object, or "surface 7".
std::string surface_name(const Snapshot &snapshot, int surface);

} // namespace penumbra
