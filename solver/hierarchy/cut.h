// Cutting an element along a line, the paper's sections 3 and 4.
#pragma once

#include "geometry/convex_pieces.h"
#include "hierarchy/forest.h"

#include <optional>

namespace penumbra {

/// Two children that tile an element, on either side of a cut, and what lies along their sides.
struct CutStep {
    int piece = 0; ///< 0: of the element itself; else 1 + the index of a child among the first step's two
    std::array<ElementBasis, 2> children;
    std::array<std::vector<SideKind>, 2> sides;
};

/// How to cut an element along a line. Planar: one step. Parametric: one when the line runs between opposite sides (or
/// cuts a triangle), two when it enters and leaves through neighbouring sides (the extra step of figure 3(b)).
struct CutPlan {
    std::vector<CutStep> steps;
    int n_snapped = 0; ///< ends of the line that were moved onto a corner, to within rounding

    /// The elements that tile it when all steps are done.
    std::vector<ElementBasis> leaves() const;
};

/// The plan for the line h = 0, or none when it misses the element or would leave a child of no width (below 1e-6 of
/// the element's size).
std::optional<CutPlan> plan_cut(const Element &element, const HalfPlane &line);

/// Carries the plan out on a leaf; the filters of its children are computed here.
void cut(Forest &forest, ElementId leaf, const CutPlan &plan, int iteration);

} // namespace penumbra
