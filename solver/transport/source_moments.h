// What a point receives from a source element through each of its basis functions.
#pragma once

#include "basis/element_basis.h"
#include "core/counters.h"
#include "geometry/convex_pieces.h"
#include "geometry/plane_frame.h"

#include <span>

namespace penumbra {

/// T_j = integral over the visible pieces of G(x,y) N_j(y) dA(y) for j < moments.size(), at the receiver point x with
/// unit normal n [no unit: irradiance per unit of the coefficient b_j]. T_0 is Lambert's closed form. Higher moments:
/// - far from a piece, a tensor Gauss rule whose size follows from distance over radius;
/// - near it, N_j(y*) Lambert + integral of G (N_j - N_j(y*)), y* the nearest point of the piece, in polar coordinates
///   about y* with both directions graded (sinh), so that touching elements cost no more than near ones.
/// `accuracy`: aimed at, relative to T_0 (1e-2 to 1e-9). Pieces lie in front of x's plane, x in front of theirs.
void source_moments(const Vec3 &x, const Vec3 &n, const PlaneFrame &source, const ElementBasis &basis,
                    const ConvexPieces &pieces, double accuracy, std::span<double> moments, Work &work);

} // namespace penumbra
