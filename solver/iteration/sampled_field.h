// What the failing sources bring to a node, at sample points: candidates for its split are scored on it.
#pragma once

#include "iteration/state.h"

#include <span>
#include <vector>

namespace penumbra {

/// Reflected radiosity [W/m2] at points of a node, each with the area it stands for.
struct SampledField {
    std::vector<Vec2> points;
    std::vector<double> areas;
    Eigen::Matrix<double, Eigen::Dynamic, 3> values; ///< points x channels
};

/// A grid of 12 x 12 over the node (over each of its tiles, fewer where these are many) and one of 6 x 6 over every small piece that a cut would make, so that a narrow
/// penumbra is seen. Where grids overlap a point stands for the inverse of their densities' sum.
SampledField sample_field(const Setting &setting, const Transport &transport, const State &state, const Element &node,
                          std::span<const Interaction *const> failing, std::span<const ElementBasis> small_pieces,
                          Work &work);

/// Squared error [(W/m2)^2, solver area] of the least-squares fit over the element by its basis. With few samples the
/// order is lowered so that there are at least two samples a coefficient: a fit through all points would show nothing.
double misfit(const SampledField &field, const ElementBasis &element);

/// Of a fit on each of the elements.
double misfit(const SampledField &field, std::span<const ElementBasis> elements);

} // namespace penumbra
