// Numbers of seventy decimal digits, for expected values that have to be right where doubles cancel.
#pragma once

#include "core/vec.h"

#include <Eigen/Core>
#include <boost/multiprecision/mpfr.hpp>

#include <array>
#include <vector>

namespace penumbra::reference {

using Digits =
    boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<70, boost::multiprecision::allocate_stack>,
                                  boost::multiprecision::et_off>;

template <int N>
struct Exact {
    std::array<Digits, N> at;

    Exact operator+(const Exact &o) const { return combined(o, 1); }
    Exact operator-(const Exact &o) const { return combined(o, -1); }
    Exact operator*(const Digits &s) const {
        Exact out;
        for (std::size_t i = 0; i < N; ++i)
            out.at[i] = at[i] * s;
        return out;
    }
    Digits dot(const Exact &o) const {
        Digits sum = 0;
        for (std::size_t i = 0; i < N; ++i)
            sum += at[i] * o.at[i];
        return sum;
    }

private:
    Exact combined(const Exact &o, int sign) const {
        Exact out;
        for (std::size_t i = 0; i < N; ++i)
            out.at[i] = sign > 0 ? Digits(at[i] + o.at[i]) : Digits(at[i] - o.at[i]);
        return out;
    }
};
using Exact2 = Exact<2>;
using Exact3 = Exact<3>;

inline Exact2 exact(const Vec2 &p) { return {{Digits(p.x()), Digits(p.y())}}; }
inline Exact3 exact(const Vec3 &p) { return {{Digits(p.x()), Digits(p.y()), Digits(p.z())}}; }
inline Digits cross(const Exact2 &a, const Exact2 &b) { return a.at[0] * b.at[1] - a.at[1] * b.at[0]; }
inline Exact3 cross(const Exact3 &a, const Exact3 &b) {
    return {{a.at[1] * b.at[2] - a.at[2] * b.at[1], a.at[2] * b.at[0] - a.at[0] * b.at[2],
             a.at[0] * b.at[1] - a.at[1] * b.at[0]}};
}

/// Gauss's rule on [0, 1] to all digits (Newton's iteration on Legendre's polynomial). Computed once for each n.
struct ExactRule {
    std::vector<Digits> points, weights;
};
const ExactRule &exact_gauss(int n);

/// Coefficients of a polynomial, lowest first.
using ExactPolynomial = std::vector<Digits>;
ExactPolynomial operator*(const ExactPolynomial &a, const ExactPolynomial &b);

/// Legendre polynomials L_0 to L_3, orthonormal on [0, 1], of the linear function a + b u, as polynomials of u.
std::array<ExactPolynomial, 4> exact_legendre(const Digits &a, const Digits &b);

} // namespace penumbra::reference
