// The curve under the cursor, found from the snapshot alone (no GL).
#pragma once

#include "render/camera.h"
#include "render/curve_filter.h"

#include <optional>

namespace penumbra {

struct CurvePick {
    int curve = 0; ///< of snapshot.curves
    Vec3 point;    ///< of the curve, nearest to the cursor on the screen; scene's own frame
};

/// The curve that passes nearest to the point x, y of the frame ([-1, 1], y up), at most `reach` pixels away in a frame
/// of `height` pixels, of those that the filter shows and that no nearer surface hides there.
std::optional<CurvePick> pick_curve(const Snapshot &snapshot, const Camera &camera, double aspect, double x, double y,
                                    double height, double reach, const CurveFilter &filter = {});

} // namespace penumbra
