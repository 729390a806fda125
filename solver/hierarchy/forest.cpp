#include "hierarchy/forest.h"

#include "core/check.h"

namespace penumbra {

Forest plant(const Scene &scene, int order) {
    Forest forest;
    forest.roots.resize(scene.surfaces.size());
    for (std::size_t s = 0; s < scene.surfaces.size(); ++s)
        for (const Polygon &part : scene.surfaces[s].parts)
            for (const Polygon &piece : quads_and_triangles(part)) {
                Element root;
                root.basis = ElementBasis(order, bilinear_quad(piece));
                root.surface = SurfaceId(s);
                root.first = forest.n_coefficients;
                forest.n_coefficients += root.basis.n_functions();
                forest.roots[s].push_back(ElementId(forest.elements.size()));
                forest.elements.push_back(std::move(root));
            }
    return forest;
}

void add_child(Forest &forest, ElementId parent, const BilinearQuad &quad, const std::array<SideKind, 4> &sides,
               int half_depth, int n_cuts, int iteration, std::shared_ptr<const TwoScale> filters) {
    Element child;
    child.basis = ElementBasis(forest[parent].basis.order(), quad);
    child.surface = forest[parent].surface;
    child.parent = parent;
    child.half_depth = half_depth;
    child.n_cuts = n_cuts;
    child.sides = sides;
    child.first = forest.n_coefficients;
    child.born = iteration;
    child.filters = std::move(filters);
    forest.n_coefficients += child.basis.n_functions();
    forest.elements.push_back(std::move(child));
}

void subdivide(Forest &forest, ElementId leaf, int iteration) {
    PENUMBRA_CHECK(forest[leaf].n_children, ==, 0);
    const ElementId first(forest.elements.size());
    const Element parent = forest[leaf];
    const auto quads = uniform_children(parent.basis.quad());
    const auto &filters = uniform_two_scale(parent.basis.order());
    for (std::size_t c = 0; c < 4; ++c) {
        // Child c keeps the parent's sides that meet in corner c; the other two are new.
        std::array<SideKind, 4> sides;
        sides.fill(SideKind::uniform);
        sides[c] = parent.sides[c];
        sides[(c + 3) % 4] = parent.sides[(c + 3) % 4];
        add_child(forest, leaf, quads[c], sides, parent.half_depth + 2, parent.n_cuts, iteration, filters[c]);
    }
    forest[leaf].first_child = first;
    forest[leaf].n_children = 4;
    forest[leaf].split = SplitKind::uniform;
}

} // namespace penumbra
