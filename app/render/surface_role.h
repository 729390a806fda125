// What a surface is to the picture: what reflects is opaque, what only blocks is seen through.
#pragma once

#include "iteration/snapshot.h"

#include <vector>

namespace penumbra {

enum class SurfaceRole { reflector, emitter, blocker }; ///< as in shaders/space.glsl
SurfaceRole role(const SnapshotSurface &surface);

/// How a surface's back looks to an eye that is behind it.
enum class Back {
    hidden, ///< a wall or floor with the whole scene before it, or the other side of another surface: not drawn
    glass,  ///< a single polygon: seen through
};
/// By surface.
std::vector<Back> backs(const Snapshot &snapshot);

/// How many polygons lie on it; of two surfaces in one plane the upper one has the smaller rank.
inline int rank(const SnapshotSurface &surface) { return static_cast<int>(surface.covers.size()); }

inline Vec3 to_space(const SnapshotSurface &s, const Vec2 &p) { return s.origin + p.x() * s.u + p.y() * s.v; }

} // namespace penumbra
