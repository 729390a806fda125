// A dashed line as the strokes that it is made of.
#pragma once

#include <glm/glm.hpp>

#include <span>
#include <vector>

namespace penumbra {

/// Dashes of length `dash` with gaps of `gap`, counted along the whole polyline, so that corners do not start anew. Each
/// is a polyline of two or more points; both lengths must be positive.
std::vector<std::vector<glm::vec2>> dashes(std::span<const glm::vec2> points, float dash, float gap);

} // namespace penumbra
