#include "render/curve_pass.h"

#include "render/styles.h"

#include <algorithm>

namespace penumbra {

glm::vec4 curve_rgba(int kind) {
    static const glm::vec4 colours[] = {{0.902f, 0.624f, 0.000f, 1},  // VE: orange
                                        {0.337f, 0.706f, 0.914f, 1},  // EV: sky blue
                                        {0.000f, 0.620f, 0.451f, 1},  // EEE: bluish green
                                        {0.835f, 0.369f, 0.000f, 1},  // plane: vermilion
                                        {0.800f, 0.475f, 0.655f, 1}}; // contact: reddish purple
    return colours[std::clamp(kind, 0, 4)];
}

CurveStroke curve_stroke(int order) {
    if (order <= 0)
        return {3.5f, 0, 1};
    return order == 1 ? CurveStroke{2.f, 0, 1} : CurveStroke{2.f, 9, 0.62f};
}

void draw_curves(const LinePass &lines, const Frame &frame, const GpuSnapshot &gpu) {
    LineStyles styles;
    // Beside one in the limelight the others stand back.
    const float opacity = frame.look.spotlight.curve >= 0 && frame.look.spotlight.surface ? 0.45f : 1;
    for (int kind = 0; kind < 5; ++kind)
        for (int order = 0; order < 3; ++order) {
            const CurveStroke stroke = curve_stroke(order);
            styles.set(styles::curve(kind, order), glm::vec4(glm::vec3(curve_rgba(kind)), opacity), stroke.width, stroke.dash, stroke.drawn);
        }
    lines.draw(frame, gpu.curves, styles, 8e-4f, {0.04, 0.05, 0.07, 0.55f * opacity});
}

} // namespace penumbra
