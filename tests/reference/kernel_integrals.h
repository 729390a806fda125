// Link coefficients by quadrature that shares nothing with the solver's: rules of Boost.Math, Legendre polynomials of
// the standard library, and singularities taken out by Duffy's transformation instead of a closed form.
#pragma once

#include "core/vec.h"

#include <Eigen/Core>

namespace penumbra::reference {

/// A rectangle that has a side on the line y = z = 0. Its first parameter runs along the line from x = from to x = to
/// (either may be the larger), its second away from the line, from 0 to `reach`.
struct HingedRectangle {
    double from, to, reach;
};

/// K_ij = 1/|p| times the integral over p and q of N_i(x) G(x,y) N_j(y), both bases orthonormal products of Legendre
/// polynomials (function k = i * order + j has degree i along the line and j away from it): irradiance coefficients on
/// p per radiosity coefficient on q. p lies in the plane z = 0, q is turned up from it by `angle`, each sees the other.
/// Both along the line enter G only by their difference w, so three dimensions are left; the pole at w = a = b = 0 (a,
/// b the distances from the line) goes with Duffy's transformation. `n` is 15, 20, 25 or 30 points a dimension.
Eigen::MatrixXd hinged_kernel(const HingedRectangle &p, const HingedRectangle &q, double angle, int order, int n = 30);

/// A parallelogram corner + s first + t second, 0 <= s, t <= 1; its front is that of first x second.
struct Parallelogram {
    Vec3 corner, first, second;
};

/// The same K_ij for two that see each other whole and do not touch (function k = i * order + j has degree i in s and j
/// in t): Gauss rules of ten points in `panels` equal parts of each parameter.
Eigen::MatrixXd clear_kernel(const Parallelogram &p, const Parallelogram &q, int order, int panels = 4);

} // namespace penumbra::reference
