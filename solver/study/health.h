// Is a solution numerically sound? Checks that do not use the links that made it.
#pragma once

#include "iteration/state.h"

namespace penumbra {

struct Health {
    /// |what the solution says arrives at the reflecting surfaces - what rays from its own radiosity bring there|, as a
    /// fraction of the emitted flux, largest channel. What rays carry to black surfaces or out of the scene is the lost
    /// part; in a closed scene of reflecting surfaces there is none.
    double energy_balance_error = 0;
    /// Emitted = absorbed + lost + drift, all channels together, as fractions of the emitted flux: absorbed by the
    /// reflecting surfaces as the solution has it, and lost, as rays carry it, to black surfaces or out of the scene.
    double absorbed = 0, lost = 0, drift = 0;
    /// Largest |sum of the form factors to all surfaces - 1| of a surface, from the links. Not a number where the sum is
    /// not 1: where rays leave the scene, or a surface is dark and so has no links.
    double closure_error = 0;
    double max_gram_error = 0;       ///< largest |<N_i, N_j> - delta_ij| of an element
    double min_radiosity = 0;        ///< of any channel, at 5 x 5 points of each leaf [W/m2]
    double max_filter_condition = 1; ///< largest ratio of singular values of a push filter
    int non_finite = 0;              ///< coefficients that are not finite
};

/// About `rays` rays in all, from deterministic points; their own error is about 1/sqrt(rays) or better.
Health health(const Scene &scene, const State &state, int rays = 200000);

} // namespace penumbra
