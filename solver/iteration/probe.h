// The solution at a point of space.
#pragma once

#include "iteration/snapshot.h"

#include <optional>

namespace penumbra {

/// Radiosity [W/m2] on the nearest patch within `reach` of x whose surface's normal makes a cosine above 0.9 with
/// `normal` (unit), evaluated from the patch's polynomial at the nearest point; nothing where there is none. Where
/// surfaces lie on each other, the one on top. All in the scene's own frame.
std::optional<Rgb> radiosity_at(const Snapshot &snapshot, const Vec3 &x, const Vec3 &normal, double reach);

} // namespace penumbra
