// Cutting an element along a line, the paper's sections 3 and 4.
#pragma once

#include "geometry/convex_pieces.h"
#include "hierarchy/forest.h"

#include <algorithm>
#include <optional>

namespace penumbra {

/// Two quads that tile an element, on either side of a cut, and what lies along their sides.
struct CutStep {
    int piece = 0; ///< 0: of the element itself; else 1 + the index of a quad among the first step's two
    std::array<BilinearQuad, 2> quads;
    std::array<std::array<SideKind, 4>, 2> sides;
};

/// How to cut an element along a line: one step when the line runs between opposite sides (or cuts a triangle), two when
/// it enters and leaves through neighbouring sides (the extra step of figure 3(b)).
struct CutPlan {
    std::vector<CutStep> steps;
    int half_depth = 0; ///< that the children are deeper: 0 for a cut along a curve
    int n_snapped = 0; ///< ends of the line that were moved onto a corner

    /// The quads that tile the element when all steps are done.
    std::vector<BilinearQuad> leaves() const;
};

/// An end of a cut this near to a corner of an element is moved there, and what is no wider is no child: a millionth of
/// the element's size, and no less than what curves that should meet may miss each other by [solver units].
constexpr double snap_reach(double element_size) { return std::max(1e-6 * element_size, 1e-8); }

/// The plan for the line h = 0, or none when it misses the element or runs along a side or past a corner, to within
/// snap_reach. tests/identity/snapping_test.cpp.
std::optional<CutPlan> plan_cut(const Element &element, const HalfPlane &line);

/// Carries the plan out on a leaf; the filters of its children are computed here.
void cut(Forest &forest, ElementId leaf, const CutPlan &plan, int iteration);

} // namespace penumbra
