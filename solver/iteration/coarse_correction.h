// One constant a surface, solved for directly: steps where reflectances are near 1.
#pragma once

#include "iteration/state.h"

namespace penumbra {

/// Of plain steps in Jacobi's order each brings one more bounce, and what is still to come after one is T d + T^2 d + ..., T
/// the transport with reflection and d = B - `before` the step's change. Its mean over each surface is estimated as c =
/// (I - A)^-1 A r for each channel, with r_s the mean of d over s, and A_st = rho_s F_st, F_st the mean irradiance on
/// s where t shines with 1 W/m2 (from the links; rows that sum to more than 1 by rounding or quadrature are scaled down
/// to 1, so that I - A stays diagonally dominant). c is added to the radiosity of every element. The fixed point
/// is that of plain steps: there d = 0, and so is c. A correction of the coarse level of a two-level method (Hackbusch
/// 1985); tests/analytic/furnace_test.cpp.
void correct_coarsely(const Setting &setting, State &state, const Coefficients &before);

/// (I - A)^-1 A mean: what constants on the surfaces (rows) bring to them by all bounces to come. After a gather in turn
/// a surface lacks what later ones changed by alone: the first A is its part above the diagonal then.
Eigen::Matrix<double, Eigen::Dynamic, 3> bounces_to_come(const Setting &setting, const State &state,
                                                         const Eigen::Matrix<double, Eigen::Dynamic, 3> &mean,
                                                         bool from_later_alone = false);

/// Whether the options and the scene call for it: `automatic` where a reflectance reaches 0.95 and plain
/// steps take 150 and more.
bool corrects_coarsely(const Setting &setting);

} // namespace penumbra
