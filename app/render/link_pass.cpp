#include "render/link_pass.h"

#include "render/link_colour.h"
#include "render/styles.h"

#include <algorithm>

namespace penumbra {

void draw_links(const LinePass &lines, const Frame &frame, const GpuSnapshot &gpu) {
    // Many links make one another out: the more there are, the fainter each is.
    const float n_links = static_cast<float>(gpu.links.size()) / 2;
    const float opacity = std::clamp(12.f / std::sqrt(std::max(1.f, n_links)), 0.06f, 0.8f);
    LineStyles styles;
    for (int kind = 0; kind < 3; ++kind)
        styles.set(styles::link(kind), glm::vec4(link_colour(kind), opacity), 1.f);
    lines.draw(frame, gpu.links, styles, 8e-4f);
}

} // namespace penumbra
