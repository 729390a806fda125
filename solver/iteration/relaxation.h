// Orders in which a gather uses what it has found: the relaxation methods of b = e + K b.
#pragma once

#include "iteration/state.h"

#include <cstdint>

namespace penumbra {

/// A step of each brings every surface up to date about once, and all have the same fixed point. Jacobi's (gather.cpp)
/// takes the radiosities of the step before. A surface is plane: its elements exchange no light, so that to relax it
/// whole is to relax its elements one after the other. Gortler, Cohen & Slusallek 1994; tests/agreement/relaxation_test.cpp.

/// Gauss-Seidel: surfaces one after the other, as the scene has them; each gathers what those before it have just got.
/// Gives the irradiance, with every element's links evaluated once. Parallel within a surface.
Coefficients gathered_in_turn(const Setting &setting, const State &state, const Cancel *cancel);

/// Southwell: the surface with the most light that it has not shot yet shoots that: all that it has links to take K times
/// its radiosity less what it shot before (progressive refinement: Cohen et al. 1988). Receivers of `renewed` batches
/// first gather anew what was shot before; then surfaces shoot until as many links were evaluated as there are. Renews state.irradiance and
/// state.shot, and gives the links evaluated. Where steps are corrected coarsely each surface shoots at most once, and what
/// it receives has to wait for the next step: the correction took these bounces ahead. Parallel over receivers.
struct Shots {
    std::int64_t links = 0;
    int surfaces = 0;
};
Shots shoot(const Setting &setting, State &state, const std::vector<char> &renewed, const Cancel *cancel);

} // namespace penumbra
