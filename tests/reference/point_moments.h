// What a point receives from an element, to seventy digits: what source_moments is held against.
#pragma once

#include "basis/element_basis.h"
#include "geometry/plane_frame.h"
#include "reference/many_digits.h"

#include <span>
#include <vector>

namespace penumbra::reference {

/// T_j = integral of G N_j over a convex piece of the element, all doubles given taken as exact (the source's normal is
/// that of u x v). Along a line of constant v of a bilinear map G N_j is a polynomial over a squared quadratic, which
/// has a closed form; across, Gauss panels of `n` points graded towards the lines near x. Of the element only its
/// definition is used: its corners and order, and of the planar family the box in which its polynomials are numbered;
/// these are orthonormalised here. `piece` must be the whole element unless the element is planar or a parallelogram.
std::vector<Digits> point_moments(const Vec3 &x, const Vec3 &n, const PlaneFrame &source, const ElementBasis &element,
                                  std::span<const Vec2> piece, int n_points = 14);

/// Lambert's closed form, in a formula that shares nothing with the above (edge by edge, with vectors in space).
Digits exact_lambert(const Vec3 &x, const Vec3 &n, const PlaneFrame &source, std::span<const Vec2> polygon);

} // namespace penumbra::reference
