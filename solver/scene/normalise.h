// Centring and scaling to unit size, before anything else: tolerances are fractions of the scene's size from here on.
#pragma once

#include "scene/build_scene.h"

namespace penumbra {

/// Moves the bounding box of all faces to centre 0 and diagonal 1 and returns the way back. The division is by the
/// diagonal itself, so that a scene scaled by a power of two gives the same bits. Throws BadInput where the box is a
/// point, or so large that its diagonal overflows.
OwnFrame normalise(RawScene &raw);

} // namespace penumbra
