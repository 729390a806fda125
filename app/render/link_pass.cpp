#include "render/link_pass.h"

#include "render/styles.h"

#include <algorithm>

namespace penumbra {

void draw_links(const LinePass &lines, const Frame &frame, const GpuSnapshot &gpu) {
    // Many links make one another out: the more there are, the fainter each is.
    const float n_links = static_cast<float>(gpu.links.size()) / 2;
    const float opacity = std::clamp(12.f / std::sqrt(std::max(1.f, n_links)), 0.06f, 0.8f);
    LineStyles styles;
    styles.set(styles::link(0), {0.35, 0.70, 0.90, opacity}, 1.f); // clear
    styles.set(styles::link(1), {0.95, 0.90, 0.25, opacity}, 1.f); // near or touching
    styles.set(styles::link(2), {0.85, 0.40, 0.65, opacity}, 1.f); // partly hidden
    lines.draw(frame, gpu.links, styles, 8e-4f);
}

} // namespace penumbra
