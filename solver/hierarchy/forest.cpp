#include "hierarchy/forest.h"

#include "core/check.h"
#include "hierarchy/planar_split.h"

#include <utility>

namespace penumbra {

namespace {

std::vector<ElementBasis> roots_of(const Polygon &part, int order, BasisFamily family) {
    if (family == BasisFamily::planar)
        return {ElementBasis(order, PlanarDomain(part))};
    std::vector<ElementBasis> roots;
    for (const Polygon &piece : quads_and_triangles(part))
        roots.emplace_back(order, bilinear_quad(piece));
    return roots;
}

} // namespace

Forest plant(const Scene &scene, int order, BasisFamily family) {
    Forest forest;
    forest.roots.resize(scene.surfaces.size());
    for (std::size_t s = 0; s < scene.surfaces.size(); ++s)
        for (const Polygon &part : scene.surfaces[s].parts)
            for (ElementBasis &basis : roots_of(part, order, family)) {
                Element root;
                root.basis = std::move(basis);
                root.surface = SurfaceId(s);
                root.sides.assign(root.basis.quad() ? 4 : root.basis.outline().size(), SideKind::outline);
                root.first = forest.n_coefficients;
                forest.n_coefficients += root.basis.n_functions();
                forest.roots[s].push_back(ElementId(forest.elements.size()));
                forest.elements.push_back(std::move(root));
            }
    return forest;
}

void add_child(Forest &forest, ElementId parent, ElementBasis basis, std::vector<SideKind> sides, int half_depth,
               int n_cuts, int iteration, std::shared_ptr<const TwoScale> filters) {
    Element child;
    child.basis = std::move(basis);
    child.surface = forest[parent].surface;
    child.parent = parent;
    child.half_depth = half_depth;
    child.n_cuts = n_cuts;
    child.sides = std::move(sides);
    child.first = forest.n_coefficients;
    child.born = iteration;
    child.filters = std::move(filters);
    forest.n_coefficients += child.basis.n_functions();
    forest.elements.push_back(std::move(child));
}

std::vector<ElementBasis> uniform_children(const Element &element) {
    std::vector<ElementBasis> children;
    if (const BilinearQuad *quad = element.basis.quad()) {
        for (const BilinearQuad &child : uniform_children(*quad))
            children.emplace_back(element.basis.order(), child);
        return children;
    }
    for (PlanarPiece &half : bisected(element.basis.planar()->domain, element.sides))
        children.emplace_back(element.basis.order(), std::move(half.domain));
    return children;
}

int uniform_half_depth(const ElementBasis &basis) { return basis.quad() ? 2 : 1; }

namespace {

/// Child c keeps the parent's sides that meet in corner c; the other two are new.
std::vector<SideKind> quarter_sides(const Element &parent, std::size_t c) {
    std::vector<SideKind> sides(4, SideKind::uniform);
    sides[c] = parent.sides[c];
    sides[(c + 3) % 4] = parent.sides[(c + 3) % 4];
    return sides;
}

void add_quarters(Forest &forest, ElementId leaf, const Element &parent, int iteration) {
    const std::vector<ElementBasis> children = uniform_children(parent);
    const auto &filters = uniform_two_scale(parent.basis.order());
    for (std::size_t c = 0; c < 4; ++c)
        add_child(forest, leaf, children[c], quarter_sides(parent, c), parent.half_depth + 2, parent.n_cuts, iteration,
                  filters[c]);
}

void add_halves(Forest &forest, ElementId leaf, const Element &parent, int iteration) {
    for (PlanarPiece &half : bisected(parent.basis.planar()->domain, parent.sides)) {
        ElementBasis basis(parent.basis.order(), std::move(half.domain));
        auto filters = std::make_shared<const TwoScale>(two_scale(parent.basis, basis));
        add_child(forest, leaf, std::move(basis), std::move(half.sides), parent.half_depth + 1, parent.n_cuts, iteration,
                  std::move(filters));
    }
}

} // namespace

std::vector<std::vector<ElementId>> elements_by_surface(const Forest &forest) {
    std::vector<std::vector<ElementId>> out(forest.roots.size());
    for (std::size_t e = 0; e < forest.elements.size(); ++e)
        out[forest.elements[e].surface.at()].emplace_back(e);
    return out;
}

void subdivide(Forest &forest, ElementId leaf, int iteration) {
    PENUMBRA_CHECK(forest[leaf].n_children, ==, 0);
    const ElementId first(forest.elements.size());
    const Element parent = forest[leaf];
    if (parent.basis.quad())
        add_quarters(forest, leaf, parent, iteration);
    else
        add_halves(forest, leaf, parent, iteration);
    forest[leaf].first_child = first;
    forest[leaf].n_children = static_cast<int>(forest.elements.size()) - first.index;
    forest[leaf].split = SplitKind::uniform;
}

} // namespace penumbra
