// What lies under the cursor, found in double precision from the snapshot alone (no GL).
#pragma once

#include "iteration/snapshot.h"
#include "render/camera.h"

#include <optional>

namespace penumbra {

struct Pick {
    int surface = 0; ///< of snapshot.surfaces
    int patch = -1;  ///< of snapshot.patches; -1 where the surface has none (a covered part)
    Vec3 point;      ///< scene's own frame
    Rgb radiosity;   ///< [W/m2]; zero where there is no patch
};

/// Nearest surface whose front is seen through the point x, y of the frame ([-1, 1], y up). What is drawn see-through
/// (backs, black blockers) is looked through, too.
std::optional<Pick> pick(const Snapshot &snapshot, const Camera &camera, double aspect, double x, double y);

/// The patch of the surface that holds point p of its plane, or -1.
int patch_at(const Snapshot &snapshot, int surface, const Vec2 &p);

} // namespace penumbra
