// A refinement in the middle: the mesh when some of its splits were made and the others were not.
#pragma once

#include "iteration/snapshot.h"

#include <memory>

namespace penumbra {

/// The number of splits in the refinement that the snapshot was taken after; 0 after other phases.
int n_events(const Snapshot &snapshot);

/// The snapshot of a refinement as it would be after its first n splits, 0 <= n <= n_events: elements whose turn has not
/// come are patches, with the polynomial that their pieces inherit, so that colours are the same (pieces of a parametric cut
/// come as near as their own polynomials can); of links they have those that failed. Pieces of the n-th split alone are fresh; counters of patches, coefficients, links, splits and cuts, and the
/// sentence, are what they were then. The version is the same for the same n of the same snapshot, and no other's.
/// tests/agreement/split_events_test.cpp: with n = 0 it is the mesh before, with all of them the mesh after.
std::shared_ptr<const Snapshot> after_splits(const Snapshot &whole, int n);
std::uint64_t version_after(const Snapshot &whole, int n);

} // namespace penumbra
