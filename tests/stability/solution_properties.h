// What must hold of every solution, whatever the scene.
#pragma once

#include "iteration/state.h"
#include "study/measurement.h"

#include <vector>

namespace penumbra {

/// Finite; not below black (by more than 1e-6 of the largest radiosity for constants, than the threshold of the largest
/// reflected one else, at 5 x 5 points of each leaf's tiles that nothing covers); a fixed point; reciprocity of links;
/// and the balance of energy.
///
/// Reciprocity: |A_p| K_00 of a link equals |A_q| K_00 of the link back, to within the accuracy asked for and a quarter
/// of what the two fits miss at their test points (K_00 of a clear pair is off by an eighth of that at most,
/// tests/agreement/links_test.cpp); and so do the sums over all links between two surfaces. In the parametric family
/// only parallelograms have it. Surfaces with covers and links too weak to be tested are left out.
std::vector<Measurement> properties(const Scene &scene, const Options &options, const State &state);

/// The balance of energy: emitted = absorbed + lost, in each channel, within 0.5 % of what is emitted. The lost part (out of the
/// scene, onto backs, onto black surfaces) and the areas that covers leave are found by rays against all polygons
/// (reference/rays.h) in sixteen batches with random places, whose scatter gives the standard error; 256000 rays or
/// more, until that is below 0.1 %. What is emitted is small beside what is reflected in a bright closed room: a solution
/// within 0.5 % of B - E balances to that, one of a coarse threshold need not.
std::vector<Measurement> balance(const Scene &scene, const State &state);

/// Root mean square difference of two solutions whose errors were measured, as a fraction of B - E's root mean square; at
/// most the sum of their errors' upper limits.
Measurement agreement(const Scene &scene, const State &parametric, const State &planar);

} // namespace penumbra
