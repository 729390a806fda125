// Discontinuity curves: colour says the kind, line style the order.
#pragma once

#include "render/gpu_snapshot.h"
#include "render/line_pass.h"

namespace penumbra {

/// Of a CurveKind: Okabe & Ito (2008), told apart by colour-blind people.
glm::vec4 curve_rgba(int kind);
struct CurveStroke {
    float width = 2, dash = 0, drawn = 1; ///< pixels, pixels (0: solid), part of the dash
};
/// Of an order: 0 thick, 1 solid, 2 dashed.
CurveStroke curve_stroke(int order);

void draw_curves(const LinePass &lines, const Frame &frame, const GpuSnapshot &gpu);

} // namespace penumbra
