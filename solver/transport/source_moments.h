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
///   about y* with both directions graded (sinh), so that touching elements cost no more than near ones;
/// - near a triangle of the parametric family, whose functions depend on the direction about its double corner, the same
///   along rays from that corner.
/// `accuracy`: relative to T_0 (1e-2 to 1e-9). Pieces lie in front of x's plane, x in front of theirs. For each piece
///   |T_j - exact| <= (accuracy T_0 + rounding) max |N_j|,
///   rounding = 16 eps D (1 + d / w) min(T_0 / h, 1 / d) + eps,
/// eps = 2^-52 (the last term is what Lambert's sum leaves where its terms cancel), D the largest distance of x and the element's corners from the frame's origin (whence eps D is the error of a
/// position), h the smaller of x's height above the source's plane and y*'s above that of x, d the distance of x from the
/// piece's outline, w the element's area over its diameter. Checked by tests/agreement/source_moments_test.cpp, for whole
/// elements and for parts of parallelograms and of planar elements.
void source_moments(const Vec3 &x, const Vec3 &n, const PlaneFrame &source, const ElementBasis &basis,
                    const ConvexPieces &pieces, double accuracy, std::span<double> moments, Work &work);

} // namespace penumbra
