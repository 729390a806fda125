#include "plot/canvas.h"

#include <cmath>
#include <numbers>

namespace penumbra {

namespace {

std::vector<glm::vec2> regular(glm::vec2 at, int n, float radius, float first_angle) {
    std::vector<glm::vec2> corners;
    for (int k = 0; k < n; ++k) {
        const float angle = first_angle - 2 * std::numbers::pi_v<float> * static_cast<float>(k) / static_cast<float>(n);
        corners.push_back(at + radius * glm::vec2(std::cos(angle), std::sin(angle)));
    }
    return corners;
}

} // namespace

std::vector<glm::vec2> marker_corners(glm::vec2 at, PlotMarker shape, float radius) {
    constexpr float quarter = std::numbers::pi_v<float> / 2;
    switch (shape) {
    case PlotMarker::circle:
        return regular(at, 24, radius, 0);
    case PlotMarker::square:
        return regular(at, 4, 1.25f * radius, quarter / 2);
    case PlotMarker::diamond:
        return regular(at, 4, 1.35f * radius, 0);
    case PlotMarker::triangle:
        return regular({at.x, at.y + 0.2f * radius}, 3, 1.4f * radius, -quarter);
    case PlotMarker::cross:
        break;
    }
    const float r = radius;
    return {{at.x - r, at.y - r}, {at.x + r, at.y + r}, {at.x - r, at.y + r}, {at.x + r, at.y - r}};
}

} // namespace penumbra
