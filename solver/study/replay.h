// One scene's decisions on another: what rounding alone changes.
#pragma once

#include "study/trial.h"

#include <Eigen/Geometry>

namespace penumbra {

/// x -> linear x + offset in the scenes' own frames, linear a multiple of an orthogonal matrix: radiosity stays the
/// same.
using Similarity = Eigen::Transform<double, 3, Eigen::Affine>;

/// The faces where the map carries them, their fronts with them (a mirror image turns their corners round).
Faces mapped(const Faces &faces, const Similarity &map);

/// The mesh and the links that were decided on (which elements, which pairs, how exactly), carried to the mapped scene;
/// filters and links (to nine digits: which rule integrates an element may hang on the order of its corners) are
/// computed there anew, and iterated to the fixed point: no change above 1e-15 of the peak, or 1000 steps. With the
/// identity: the fixed point of the decided mesh, to rounding. Differs from a solution of the mapped scene in the
/// decisions that hang on rounding. Throws Cancelled.
Trial replay(const Trial &decided, const Faces &faces, const Similarity &map);

} // namespace penumbra
