// How much a far source's light can vary over an element.
#pragma once

#include "hierarchy/forest.h"

#include <span>

namespace penumbra {

/// Of an element p and nodes q that tile a source S and see each other whole: an upper bound of
///   |integral over S of G(x,y) b(y) dA - sum over the q of mean_p(F_q) mean_q(b)|,   x in p, 0 <= b <= 1,
/// what constants on both sides miss at most. Moving x in p's plane or y in that of S, the kernel G changes by no more than
/// (sin a / (pi d^3) + 4 G / d) a unit of length, a the angle of the two planes and d the distance; the points of p
/// are at most sqrt(2) of its spread from any one of them, in the root mean square. `form_factor`: the largest from a point of p
/// to S. Infinite where no plane across the line of centres parts the two. tests/agreement/variation_test.cpp.
double variation_bound(const Forest &forest, const Element &p, const Surface &to, const Surface &from,
                       std::span<const ElementId> nodes, double form_factor);

} // namespace penumbra
