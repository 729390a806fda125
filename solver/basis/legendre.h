// Legendre polynomials, orthonormal on [0, 1].
#pragma once

#include <array>

namespace penumbra {

/// L_0(t) to L_3(t): sqrt(2k+1) P_k(2t-1), so that the integral of L_i L_j over [0,1] is 1 for i = j and 0 otherwise.
inline std::array<double, 4> legendre(double t) {
    const double x = 2 * t - 1;
    return {1.0, 1.7320508075688772 * x, 2.2360679774997897 * (1.5 * x * x - 0.5),
            2.6457513110645907 * x * (2.5 * x * x - 1.5)};
}

/// Their derivatives.
inline std::array<double, 4> legendre_slopes(double t) {
    const double x = 2 * t - 1;
    return {0.0, 2 * 1.7320508075688772, 2 * 2.2360679774997897 * 3 * x, 2 * 2.6457513110645907 * (7.5 * x * x - 1.5)};
}

} // namespace penumbra
