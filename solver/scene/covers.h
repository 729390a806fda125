// Coplanar overlap: a lamp in its ceiling, a box on its floor, the same face twice.
#pragma once

#include "scene/scene.h"

namespace penumbra {

/// Surfaces lie in one plane when no corner of either is farther than this from the other's (unit size).
inline constexpr double coplanar_within = 1e-9;

/// Whether two surfaces lie in one plane, whichever way each of them faces.
bool in_one_plane(const Surface &a, const Surface &b);

/// Largest number of pairs of convex parts that may lie in one plane with boxes that meet; beyond it, BadInput.
inline constexpr std::size_t most_coplanar_pairs = 4'000'000;

/// Fills `covers` of all surfaces. Where two surfaces overlap in one plane and face the same way, the emitter, else the
/// later, lies on top and covers the other; where they face each other's way, each covers the other. The two sides of
/// one double-sided face never do, be they one face of the file or two with the same corners, back to back; nor do
/// surfaces that only touch. Covers of different surfaces may overlap.
void find_covers(Scene &scene);

} // namespace penumbra
