#include "geometry/polygon.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Partition_traits_2.h>
#include <CGAL/partition_2.h>

#include <cmath>
#include <cstddef>
#include <iterator>
#include <list>
#include <utility>

namespace penumbra {

namespace {

/// A reflex corner of the whole is often in line with its neighbours in a part (a wall on both sides of a door): a quad
/// made of such corners would have no area.
Polygon without_corners_in_line(Polygon part) {
    constexpr double in_line = 1e-12; // of the unit scene
    for (std::size_t i = 0; i < part.size() && part.size() > 3;) {
        const Vec2 &before = part[(i + part.size() - 1) % part.size()], &after = part[(i + 1) % part.size()];
        if (std::abs(cross(after - before, part[i] - before)) <= in_line * (after - before).norm()) {
            part.erase(part.begin() + static_cast<std::ptrdiff_t>(i));
            i = 0;
        } else {
            ++i;
        }
    }
    return part;
}

} // namespace

std::vector<Polygon> convex_parts(const Polygon &polygon) {
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    using Traits = CGAL::Partition_traits_2<Kernel>;
    using Part = Traits::Polygon_2;

    Part input;
    for (const Vec2 &p : polygon)
        input.push_back({p.x(), p.y()});
    if (input.is_convex())
        return {polygon};
    std::list<Part> found;
    // The optimal partition takes O(n^4) time and O(n^3) memory (Greene 1983); the other has at most four times as many
    // parts (Hertel & Mehlhorn 1983).
    constexpr std::size_t largest_for_optimal = 32;
    if (polygon.size() <= largest_for_optimal)
        CGAL::optimal_convex_partition_2(input.vertices_begin(), input.vertices_end(), std::back_inserter(found));
    else
        CGAL::approx_convex_partition_2(input.vertices_begin(), input.vertices_end(), std::back_inserter(found));
    std::vector<Polygon> parts;
    for (const Part &part : found) {
        Polygon out;
        for (auto p = part.vertices_begin(); p != part.vertices_end(); ++p)
            out.emplace_back(p->x(), p->y());
        parts.push_back(without_corners_in_line(std::move(out)));
    }
    return parts;
}

} // namespace penumbra
