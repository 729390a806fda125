// What a solution of constants looked like in 1993.
#pragma once

#include "iteration/state.h"

namespace penumbra {

/// A field of quadratics on the leaves of a solution: its own forest, whose elements differ from the solution's in their
/// order alone. Only leaves have coefficients that mean anything.
struct QuadraticField {
    Forest forest;
    Coefficients radiosity; ///< W/m2
};

/// Reconstructs the solution for the eye (Lischinski, Tampieri & Greenberg 1993, local pass; quadratic elements as in
/// their 1992 paper): what the leaf's links and those above it bring to its nodes, each link's source as seen from the
/// node, interpolated by a quadratic. Nodes are the corners, the middles of the sides and the centre, drawn in by a
/// thousandth of the element, so that borders between elements and between surfaces stay sharp; on a quad the
/// biquadratic through them, on other polygons the quadratic of least squares. Cancellable.
QuadraticField reconstruct(const Setting &setting, const State &state, const Cancel *cancel);

} // namespace penumbra
