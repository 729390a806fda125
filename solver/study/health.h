// Is a solution numerically sound? Checks that do not use the links that made it.
#pragma once

#include "iteration/state.h"

namespace penumbra {

struct Health {
    /// |what the solution says arrives at the reflecting surfaces - what rays from its own radiosity bring there|, as a
    /// fraction of the emitted flux, largest channel. What rays carry to black surfaces or out of the scene is the lost
    /// part; in a closed scene of reflecting surfaces there is none.
    double energy_balance_error = 0;
    double lost = 0;                 ///< of the flux that leaves all surfaces, the share that meets no reflecting one
    double min_radiosity = 0;        ///< of any channel, at 5 x 5 points of each leaf [W/m2]
    double max_filter_condition = 1; ///< largest ratio of singular values of a push filter
    int non_finite = 0;              ///< coefficients that are not finite
};

/// About `rays` rays in all, from deterministic points; their own error is about 1/sqrt(rays) or better.
Health health(const Scene &scene, const State &state, int rays = 200000);

} // namespace penumbra
