// Colours for signed values.
#pragma once

#include <glm/glm.hpp>

namespace penumbra {

/// At t in [-1, 1], sRGB: blue below 0, nearly white at 0, brown above, darker with the distance from 0 on either side;
/// nine points of Crameri's vik (2018). Colour-blind people tell the two sides apart: tests/golden/diverging_test.cpp.
glm::dvec3 diverging(double t);

} // namespace penumbra
