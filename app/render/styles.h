// Numbers of the styles that lines and tinted polygons are drawn in: indices into the tables that the passes hand to
// their shaders.
#pragma once

#include "iteration/snapshot.h"
#include "render/surface_role.h"

namespace penumbra::styles {

// Lines (16 at most for each pass).
inline int mesh_side(SideKind kind, bool fresh) { return static_cast<int>(kind) + (fresh ? 3 : 0); }
inline int outline(SurfaceRole role) { return static_cast<int>(role); }
inline int curve(int kind, int order) { return 3 * kind + order; }
inline constexpr int newest_side = 0;
inline int newest_curve(int kind) { return 1 + kind; }
inline int link(int kind) { return kind; }

// Polygons.
inline constexpr int cover = 3;
inline int glass(SurfaceRole role) { return static_cast<int>(role); }

} // namespace penumbra::styles
