// Push and pull filters between a parent's basis and a child's.
#pragma once

#include "basis/element_basis.h"

#include <array>
#include <memory>

namespace penumbra {

/// b_child = push b_parent (6) and b_parent = sum over the children of pull b_child (7).
struct TwoScale {
    Eigen::MatrixXd push; ///< n_child x n_parent
    Eigen::MatrixXd pull; ///< n_parent x n_child
};

/// Pulls of the planar family are the transposed pushes by the child's share of the area, and their round trips the
/// identity to rounding for children of any shape. For the parametric one:
/// the filters of any child inside its parent, integrated over the child with `n` Gauss points a parameter. A round trip,
/// the sum of pull push over children that tile the parent, is the identity on polynomials of the plane of total degree
/// below the smaller order; on the rest of a parametric basis it is so for uniform children only.
TwoScale two_scale(const ElementBasis &parent, const ElementBasis &child, int n = 16);

/// The predefined filters of the four children of a uniform split of the parameter square, children in the order of
/// uniform_children(); the same for every element and level.
const std::array<std::shared_ptr<const TwoScale>, 4> &uniform_two_scale(int order);

/// Quarters of the parameter square: (u,v) halves low-low, high-low, high-high, low-high.
std::array<BilinearQuad, 4> uniform_children(const BilinearQuad &quad);

} // namespace penumbra
