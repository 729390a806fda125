#include "plot/dashes.h"

namespace penumbra {

std::vector<std::vector<glm::vec2>> dashes(std::span<const glm::vec2> points, float dash, float gap) {
    std::vector<std::vector<glm::vec2>> strokes;
    bool drawn = true;  // whether the present piece is a dash
    float left = dash;  // of it
    bool begun = false; // whether strokes.back() goes on
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const glm::vec2 a = points[i], b = points[i + 1];
        const float length = glm::distance(a, b);
        for (float at = 0; at < length;) {
            const bool ends_here = at + left <= length;
            const float to = ends_here ? at + left : length;
            if (drawn) {
                if (!begun)
                    strokes.push_back({glm::mix(a, b, at / length)});
                strokes.back().push_back(glm::mix(a, b, to / length));
            }
            begun = drawn && !ends_here;
            left -= to - at;
            at = to;
            if (ends_here) {
                drawn = !drawn;
                left = drawn ? dash : gap;
            }
        }
    }
    return strokes;
}

} // namespace penumbra
