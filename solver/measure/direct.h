// The exact direct solution: what emitters bring to a point, each with its exact visible part.
#pragma once

#include "discontinuity/hidden_pairs.h"
#include "transport/interaction.h"

namespace penumbra {

/// sum over the emitters of E_S times Lambert's formula over what the point sees of S, at a point of a surface's plane: the
/// irradiance of light that was not reflected yet [W/m2]. Independent of elements and links. 0 where covered. Emitters that
/// `hidden` knows to see nothing of the surface are passed over.
Rgb direct_irradiance(const Scene &scene, const Blockers &blockers, SurfaceId surface, const Vec2 &point, Work &work,
                      const HiddenPairs *hidden = nullptr);

/// B = E + rho times that. Dark where the surface is covered.
Rgb direct_radiosity(const Scene &scene, const Blockers &blockers, SurfaceId surface, const Vec2 &point);

/// ||B_h - B|| / ||B - E|| in L2 over all reflecting surfaces and the three channels together, B the exact direct
/// solution, at 4 x 4 Gauss points in each cell of a grid in every leaf (about 40 x 40 cells a surface part, at least 2 x 2 a
/// leaf), covered ones left out.
double direct_error(const Scene &scene, const Blockers &blockers, const Forest &forest, const Coefficients &radiosity);

} // namespace penumbra
