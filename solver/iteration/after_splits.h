// A refinement in the middle: the mesh when some of its splits were made and the others were not, and then the links.
#pragma once

#include "iteration/snapshot.h"

#include <memory>
#include <optional>

namespace penumbra {

/// The number of splits in the refinement that the snapshot was taken after, and of pairs that it linked after all these; 0
/// after other phases.
int n_events(const Snapshot &snapshot);
int n_linkings(const Snapshot &snapshot);

/// The snapshot of a refinement as it would be after its first n splits, 0 <= n <= n_events: elements whose turn has not
/// come are patches, with the polynomial that their pieces inherit, so that colours are the same (pieces of a parametric cut
/// come as near as their own polynomials can); of links there are those that were there before, less those of elements that
/// were split. Pieces of the n-th split alone are fresh; counters of patches, coefficients, links, splits and cuts, and the
/// sentence, are what they were then. The version is the same for the same n of the same snapshot, and no other's.
/// tests/agreement/split_events_test.cpp: with n = 0 it is the mesh before, with all of them the mesh after.
std::shared_ptr<const Snapshot> after_splits(const Snapshot &whole, int n);
std::uint64_t version_after(const Snapshot &whole, int n);

/// After all splits and the first n pairs that were linked, 0 <= n <= n_linkings: nothing is fresh. Else the same.
std::shared_ptr<const Snapshot> after_linkings(const Snapshot &whole, int n);
std::uint64_t version_after_linkings(const Snapshot &whole, int n);

/// What is shown of a refinement: its first splits, or else all of these and the first pairs that it linked; more than there
/// are: all. Nothing given, or none there: the whole.
struct RefinementPart {
    std::optional<int> splits{}, linkings{};
};
std::uint64_t version_of(const Snapshot &whole, const RefinementPart &part);
/// Null for the whole.
std::shared_ptr<const Snapshot> part_of(const Snapshot &whole, const RefinementPart &part);

} // namespace penumbra
