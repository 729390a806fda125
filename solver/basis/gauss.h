// Gauss-Legendre rules on [0, 1].
#pragma once

#include <span>
#include <vector>

namespace penumbra {

struct GaussRule {
    std::vector<double> points;  ///< ascending, inside (0, 1)
    std::vector<double> weights; ///< positive, sum 1
};

/// The rule of n points, 1 <= n <= 64; exact for polynomials of degree 2n - 1. Computed once (Newton's iteration on P_n).
const GaussRule &gauss_rule(int n);

} // namespace penumbra
