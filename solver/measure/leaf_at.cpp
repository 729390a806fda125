#include "measure/leaf_at.h"

#include <limits>
#include <ranges>

namespace penumbra {

namespace {

/// Distance of p from the nearest side's line, positive inside.
double depth_inside(const Polygon &convex, const Vec2 &p) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < convex.size(); ++i) {
        const Vec2 &a = convex[i], side = convex[(i + 1) % convex.size()] - a;
        if (const double length = side.norm(); length > 0)
            least = std::min(least, cross(side, p - a) / length);
    }
    return least;
}

/// Whether p lies on the inner side of all sides: as depth_inside > 0, without lengths.
bool strictly_inside(const Polygon &convex, const Vec2 &p) {
    for (std::size_t i = 0; i < convex.size(); ++i) {
        const Vec2 &a = convex[i], side = convex[i + 1 < convex.size() ? i + 1 : 0] - a;
        if (cross(side, p - a) <= 0 && side != Vec2::Zero())
            return false;
    }
    return true;
}

/// Of elements that tile a region: the first that holds the point, else the one that it is least outside of.
template <class Elements>
ElementId holder(const Forest &forest, const Elements &elements, const Vec2 &point) {
    for (const ElementId e : elements)
        if (strictly_inside(forest[e].basis.outline(), point))
            return e;
    ElementId at;
    double most_inside = -std::numeric_limits<double>::infinity();
    for (const ElementId e : elements)
        if (const double depth = depth_inside(forest[e].basis.outline(), point); depth > most_inside) {
            most_inside = depth;
            at = e;
        }
    return at;
}

} // namespace

ElementId leaf_at(const Forest &forest, SurfaceId surface, const Vec2 &point) {
    ElementId at = holder(forest, forest.roots[surface.at()], point);
    while (!forest[at].leaf()) {
        const Element &parent = forest[at];
        const auto child = [&](int c) { return ElementId(parent.first_child.index + c); };
        at = holder(forest, std::views::iota(0, parent.n_children) | std::views::transform(child), point);
    }
    return at;
}

Rgb radiosity_at(const Forest &forest, const Coefficients &radiosity, SurfaceId surface, const Vec2 &point) {
    const Element &e = forest[leaf_at(forest, surface, point)];
    return (e.basis.evaluate(point).transpose() * radiosity.middleRows(e.first, e.basis.n_functions()))
        .transpose()
        .array();
}

} // namespace penumbra
