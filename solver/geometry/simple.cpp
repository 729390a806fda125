#include "geometry/simple.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>

namespace penumbra {

bool is_simple(const Polygon &polygon) {
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    std::vector<Kernel::Point_2> points;
    for (const Vec2 &p : polygon)
        points.emplace_back(p.x(), p.y());
    return CGAL::is_simple_2(points.begin(), points.end(), Kernel());
}

} // namespace penumbra
