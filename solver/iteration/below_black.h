// Radiosity that no light can have.
#pragma once

#include "hierarchy/push_pull.h"

namespace penumbra {

/// How far a leaf's radiosity is below black anywhere [W/m2], and what its detail would have to be multiplied by to be no more
/// than `aim` below: (mean + aim) / (mean - least), of the channel where that is least (the limiter of X. Zhang and
/// C.-W. Shu 2010, with black - aim for a bound).
struct Darkness {
    double depth = 0, damping = 1;
    Vec2 at = Vec2::Zero(); ///< where it is darkest
};

/// At 7 x 7 points of each of its tiles and, where its range allows that a minimum between these is too low, at 13 x 13 and
/// downhill from there; what is covered is left out. 0 and 1 where it is nowhere more than `aim` below.
Darkness below_black(const Scene &scene, const Element &leaf, const Coefficients &radiosity, double aim);

} // namespace penumbra
