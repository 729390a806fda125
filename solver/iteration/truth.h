// What radiosity on a scene really is, in the frame that snapshots have.
#pragma once

#include "iteration/snapshot.h"
#include "measure/reference.h"

#include <functional>
#include <memory>

namespace penumbra {

/// Immutable; may be asked from several threads.
struct Truth {
    std::function<Rgb(int surface, const Vec2 &point)> radiosity_at; ///< B [W/m2] at a point of the surface's plane
    double error = 0;                                                ///< its own relative L2 error, about; 0: exact
};

/// A reference (measure/reference.h) asked in the scene's own frame.
Truth truth_of(std::shared_ptr<const Scene> scene, std::shared_ptr<const Reference> reference);

} // namespace penumbra
