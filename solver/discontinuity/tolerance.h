// How near is the same.
#pragma once

namespace penumbra {

/// Points that lie closer than this are one point, and a point this close to a plane lies in it [solver units]. It
/// absorbs the rounding of readers and of the scene's scaling; beyond it, sides are decided exactly.
inline constexpr double coincidence = 1e-9;

/// Blockers' corners this close become one, and those this close to the receiver's or the source's plane are moved into
/// it [solver units]. Readers flatten bent faces by up to 1e-6, which tears the edges that faces share; through such a
/// tear every fold would look like two silhouettes, and a box on the floor would float.
inline constexpr double weld = 2e-6;

} // namespace penumbra
