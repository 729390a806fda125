// Lines of sight along the curves of bundled scenes: each starts on its curve, touches what the event names and ends on
// the source, seen by nothing but these three conditions.
#include "iteration/critical_surface.h"

#include "geometry/polygon.h"
#include "iteration/solver.h"
#include "scene/bundled.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace penumbra {
namespace {

double distance_to_segment(const Vec3 &a, const Vec3 &b, const Vec3 &p) {
    const Vec3 d = b - a;
    const double t = d.squaredNorm() > 0 ? std::clamp((p - a).dot(d) / d.squaredNorm(), 0.0, 1.0) : 0;
    return (a + t * d - p).norm();
}

double distance_to_polyline(const std::vector<Vec3> &points, const Vec3 &p) {
    double least = 1e300;
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
        least = std::min(least, distance_to_segment(points[i], points[i + 1], p));
    return least;
}

/// Of the sight's points, the distance of the nearest from the corner or the edge's line. From the line: curves that
/// coincide are merged, and keep the edge of one of them.
double distance_to_edge(const std::vector<Vec3> &sight, const SnapshotEdge &edge) {
    double least = 1e300;
    for (const Vec3 &p : sight)
        least = std::min(least, edge.is_corner() ? (p - edge.a).norm()
                                                 : (edge.b - edge.a).normalized().cross(p - edge.a).norm());
    return least;
}

class CriticalSurfaces : public testing::TestWithParam<const char *> {};

TEST_P(CriticalSurfaces, LinesOfSightTouchWhatTheirEventNames) {
    const auto scene = std::make_shared<const Scene>(open_scene(GetParam()));
    const Solver solver(scene, Options{});
    const auto snapshot = solver.snapshot();
    const double slack = 1e-5 * scene->own.size;
    int n_sights = 0, n_curves = 0;
    for (std::size_t i = 0; i < snapshot->curves->size(); ++i) {
        const SnapshotCurve &curve = (*snapshot->curves)[i];
        SCOPED_TRACE("curve " + std::to_string(i));
        const CriticalSurface surface = critical_surface(*snapshot, curve, 17);
        if (curve.touched.empty())
            continue;
        if (!surface.sheet.empty()) { // edges in one plane with the curve
            for (const Vec3 &p : surface.sheet)
                EXPECT_LT(std::abs((p - surface.sheet[0])
                                       .dot((surface.sheet[1] - surface.sheet[0])
                                                .cross(surface.sheet[2] - surface.sheet[0])
                                                .normalized())),
                          slack);
            continue;
        }
        ++n_curves;
        EXPECT_GE(surface.sights.size(), 2u); // the two at the ends may be lost, and more where curves were merged
        for (const SnapshotEdge &edge : curve.touched)
            EXPECT_GE(edge.surface, 0) << "nobody's edge";
        for (const auto &sight : surface.sights) {
            ++n_sights;
            EXPECT_LT(distance_to_polyline(curve.points, sight.front()), slack);
            for (const SnapshotEdge &edge : curve.touched)
                EXPECT_LT(distance_to_edge(sight, edge), slack);
            for (const Vec3 &stop : sight)
                EXPECT_LT(distance_to_segment(sight.front(), sight.back(), stop), slack) << "not straight";
            const SnapshotSurface &source = snapshot->surfaces[static_cast<std::size_t>(curve.source)];
            const Vec3 end = sight.back() - source.origin;
            EXPECT_TRUE(contains(source.outline, {end.dot(source.u), end.dot(source.v)}, slack)) << sight.back();
        }
    }
    EXPECT_GT(n_sights, 13 * n_curves) << "of 17 each";
}

INSTANTIATE_TEST_SUITE_P(Bundled, CriticalSurfaces,
                         testing::Values("skew-blockers", "slanted-edge", "box-on-floor", "cornell-box", "stairs"));

} // namespace
} // namespace penumbra
