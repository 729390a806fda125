// Snapshots made without a solver: known polynomials on patches of every shape, and small scenes that have in them all
// that a picture can show.
#pragma once

#include "iteration/snapshot.h"

#include <memory>
#include <vector>

namespace penumbra::synthetic {

/// A square surface [0,1]^2 in the plane z = 0 whose patches are, each in a place of its own: a square, a rectangle, a
/// trapezoid, a general convex quad, a sliver, and triangles with each of the four pairs of neighbouring corners in one
/// place. Order and coefficients differ from patch to patch; values lie around 1.
std::shared_ptr<const Snapshot> patch_zoo();

/// A floor under a lamp with a blocker: quadtree with hanging corners beside a region that is cut along a slanted line,
/// curves of all kinds and orders, some links, fresh patches.
std::shared_ptr<const Snapshot> lamp_and_blocker();

/// The same under two blockers, with two curves that are truly thrown: 0 by the lamp's corner and the lower blocker's
/// edge (VE), 1 by an edge of the lamp and one of each blocker (EEE).
std::shared_ptr<const Snapshot> two_events();

/// A closed room seen through its walls' backs, with a lamp in the ceiling's plane (the ceiling is covered there), and a
/// two-sided screen in the middle; walls red and green.
std::shared_ptr<const Snapshot> closed_room();

} // namespace penumbra::synthetic
