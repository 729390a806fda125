// From radiosity to what the screen shows; the same as shaders/tone.glsl (tests/golden holds them together).
#pragma once

#include "render/look.h"

#include <glm/glm.hpp>

namespace penumbra {

/// Light in [0, 1] as sRGB in [0, 1] (IEC 61966-2-1), and the reverse.
double srgb(double light);
double linear_of_srgb(double value);

/// Cividis (Nunez, Anderton & Renslow 2018) at t in [0, 1], sRGB.
glm::dvec3 cividis(double t);

/// sRGB of a grey radiosity [W/m2]: exposure, then the tone curve (straight to 0.8, then bending towards 1), or
/// cividis over the range.
glm::dvec3 shown(const Look &look, const Range &range, double radiosity);

} // namespace penumbra
