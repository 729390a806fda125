#include "geometry/polygon.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Partition_traits_2.h>
#include <CGAL/partition_2.h>

#include <iterator>
#include <list>

namespace penumbra {

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
        Polygon &out = parts.emplace_back();
        for (auto p = part.vertices_begin(); p != part.vertices_end(); ++p)
            out.emplace_back(p->x(), p->y());
    }
    return parts;
}

} // namespace penumbra
