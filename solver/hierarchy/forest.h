// The hierarchy of elements of all surfaces: a tree for each convex part.
#pragma once

#include "basis/element_basis.h"
#include "basis/two_scale.h"
#include "core/ids.h"
#include "core/options.h"
#include "hierarchy/side.h"
#include "scene/scene.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace penumbra {

/// How an element's children were made; the paper's flag (section 5).
enum class SplitKind : std::uint8_t { none, uniform, cut };

struct Element {
    ElementBasis basis;
    SurfaceId surface;
    ElementId parent, first_child; ///< children stand one after the other
    int n_children = 0;            ///< 0, 2 (cut, or bisection of the planar family) or 4 (uniform)
    SplitKind split = SplitKind::none;
    int half_depth = 0;            ///< twice the halvings of both directions: a split in four adds 2, a bisection 1, a cut 0
    int n_cuts = 0;                ///< cuts above this element
    std::vector<SideKind> sides;   ///< of a quad's four sides (also one without length), or of a polygon's
    int first = 0;                 ///< of its coefficients in a coefficient array
    int born = 0;                  ///< iteration that made it
    bool at_limit = false;         ///< failed the oracle and was kept
    std::shared_ptr<const TwoScale> filters; ///< to its parent; none at a root

    bool leaf() const { return n_children == 0; }
    double depth() const { return half_depth / 2.0; }
};

struct Forest {
    std::vector<Element> elements;                ///< parents before children
    std::vector<std::vector<ElementId>> roots;    ///< by surface
    int n_coefficients = 0;                       ///< of all elements

    Element &operator[](ElementId e) { return elements[e.at()]; }
    const Element &operator[](ElementId e) const { return elements[e.at()]; }
};

/// Roots only, all of one order: a quad or triangle for each piece of a surface's convex parts, or, in the planar family,
/// the parts themselves.
Forest plant(const Scene &scene, int order, BasisFamily family = BasisFamily::parametric);

/// An element's children by a uniform split: the quarters of its parameter square, or the halves of its box across the
/// longer side (planar).
std::vector<ElementBasis> uniform_children(const Element &element);
/// What a uniform split adds to half_depth.
int uniform_half_depth(const ElementBasis &basis);

/// Splits a leaf uniformly.
void subdivide(Forest &forest, ElementId leaf, int iteration);

/// The elements of every surface, parents before children.
std::vector<std::vector<ElementId>> elements_by_surface(const Forest &forest);

/// Calls visit(id) for every leaf below (or at) e, in order.
template <class Visit>
void for_each_leaf(const Forest &forest, ElementId e, const Visit &visit) {
    const Element &element = forest[e];
    if (element.leaf()) {
        visit(e);
        return;
    }
    for (int c = 0; c < element.n_children; ++c)
        for_each_leaf(forest, ElementId(element.first_child.index + c), visit);
}

/// Appends a child with these filters; the caller sets the parent's links to its children.
void add_child(Forest &forest, ElementId parent, ElementBasis basis, std::vector<SideKind> sides, int half_depth,
               int n_cuts, int iteration, std::shared_ptr<const TwoScale> filters);

} // namespace penumbra
