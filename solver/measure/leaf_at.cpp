#include "measure/leaf_at.h"

#include <limits>

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

} // namespace

ElementId leaf_at(const Forest &forest, SurfaceId surface, const Vec2 &point) {
    ElementId at;
    double most_inside = -std::numeric_limits<double>::infinity();
    const auto consider = [&](ElementId e) {
        const double depth = depth_inside(forest[e].basis.outline(), point);
        if (depth > most_inside) {
            most_inside = depth;
            at = e;
        }
        return depth > 0;
    };
    for (const ElementId root : forest.roots[surface.at()])
        if (consider(root))
            break;
    while (!forest[at].leaf()) {
        const Element &parent = forest[at];
        most_inside = -std::numeric_limits<double>::infinity();
        for (int c = 0; c < parent.n_children; ++c)
            if (consider(ElementId(parent.first_child.index + c)))
                break;
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
