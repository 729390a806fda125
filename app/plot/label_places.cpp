#include "plot/label_places.h"

#include <algorithm>
#include <limits>

namespace penumbra {

namespace {

float overlap(const PlotBox &a, const PlotBox &b) {
    const float w = std::min(a.high.x, b.high.x) - std::max(a.low.x, b.low.x);
    const float h = std::min(a.high.y, b.high.y) - std::max(a.low.y, b.low.y);
    return w > 0 && h > 0 ? w * h : 0;
}

/// Beside the anchor: right, left, above, below, and between these; the gap is enough for a marker.
std::vector<PlotBox> around(glm::vec2 anchor, float width, float height) {
    const float gap = 0.75f * height;
    std::vector<PlotBox> boxes;
    for (const float dy : {0.f, -1.f, 1.f})
        for (const float dx : {1.f, -1.f, 0.f}) {
            if (dx == 0 && dy == 0)
                continue;
            const glm::vec2 centre = anchor + glm::vec2(dx * (gap + width / 2), dy * (gap + height / 4));
            boxes.push_back({centre - glm::vec2(width, height) / 2.f, centre + glm::vec2(width, height) / 2.f});
        }
    return boxes;
}

} // namespace

std::vector<PlotBox> place_labels(const PlotBox &box, const std::vector<LabelWish> &wishes,
                                  const std::vector<glm::vec2> &taken, float height) {
    std::vector<PlotBox> placed;
    for (const LabelWish &wish : wishes) {
        PlotBox best;
        float least = std::numeric_limits<float>::infinity();
        for (std::size_t a = 0; wish.width > 0 && a < wish.anchors.size(); ++a)
            for (const PlotBox &b : around(wish.anchors[a], wish.width, height)) {
                float cost = 1.5f * static_cast<float>(wish.anchors.size() - 1 - a);
                cost += 1000 * (1 - overlap(b, box) / (b.width() * b.height()));
                for (const PlotBox &other : placed)
                    cost += 100 * overlap(b, other) / (height * height);
                const PlotBox near{b.low - 0.25f * height, b.high + 0.25f * height}; // points are as large as marks
                cost += 10 * static_cast<float>(
                    std::ranges::count_if(taken, [&](const glm::vec2 &p) { return near.contains(p); }));
                if (cost < least) {
                    least = cost;
                    best = b;
                }
            }
        placed.push_back(best);
    }
    return placed;
}

} // namespace penumbra
