#include "iteration/critical_surface.h"

#include "geometry/polygon.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace penumbra {

namespace {

constexpr double same_place = 1e-8; ///< solver units; several roundings above `coincidence`

double distance_to_line(const Vec3 &a, const Vec3 &b, const Vec3 &p) {
    return (b - a).normalized().cross(p - a).norm();
}

bool on_outline(const Surface &surface, const TouchedEdge &edge) {
    const std::size_t n = surface.corners.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Vec3 &a = surface.corners[i], &b = surface.corners[(i + 1) % n];
        if (edge.is_corner()
                ? (a - edge.a).norm() < same_place
                : distance_to_line(a, b, edge.a) < same_place && distance_to_line(a, b, edge.b) < same_place)
            return true;
    }
    return false;
}

bool in_plane(const Surface &surface, const TouchedEdge &edge) {
    return std::abs(surface.frame.height(edge.a)) < same_place && std::abs(surface.frame.height(edge.b)) < same_place;
}

/// Whether p lies within the outline (even-odd rule) or nearer to it than 1e-5 of its size.
bool reaches(const SnapshotSurface &surface, const Vec3 &p) {
    const Vec2 at((p - surface.origin).dot(surface.u), (p - surface.origin).dot(surface.v));
    const double slack = 2e-5 * radius(surface.outline);
    bool odd = false;
    for (std::size_t i = 0; i < surface.outline.size(); ++i) {
        const Vec2 a = surface.outline[i] - at, b = surface.outline[(i + 1) % surface.outline.size()] - at, d = b - a;
        if ((a - std::clamp(a.dot(d) / d.squaredNorm(), -1.0, 0.0) * d).norm() <= slack)
            return true;
        if ((a.y() > 0) != (b.y() > 0) && (cross(a, b) > 0) == (b.y() > a.y()))
            odd = !odd;
    }
    return odd;
}

double length(const std::vector<Vec3> &polyline) {
    double sum = 0;
    for (std::size_t i = 0; i + 1 < polyline.size(); ++i)
        sum += (polyline[i + 1] - polyline[i]).norm();
    return sum;
}

/// n points of the polyline, equally far apart along it.
std::vector<Vec3> evenly(const std::vector<Vec3> &polyline, int n) {
    std::vector<Vec3> points;
    const double step = length(polyline) / (n - 1);
    double behind = 0; // length before the present piece
    std::size_t i = 0;
    for (int k = 0; k + 1 < n; ++k) {
        while (i + 2 < polyline.size() && behind + (polyline[i + 1] - polyline[i]).norm() < k * step) {
            behind += (polyline[i + 1] - polyline[i]).norm();
            ++i;
        }
        const Vec3 piece = polyline[i + 1] - polyline[i];
        points.push_back(polyline[i] + (piece.norm() > 0 ? (k * step - behind) / piece.norm() : 0) * piece);
    }
    points.push_back(polyline.back());
    return points;
}

/// Where the line x + t along passes nearest to the edge's line.
double parameter(const Vec3 &x, const Vec3 &along, const SnapshotEdge &edge) {
    if (edge.is_corner())
        return (edge.a - x).dot(along);
    const Vec3 e = (edge.b - edge.a).normalized(), across = e.cross(along.cross(e));
    return (edge.a - x).dot(across) / along.dot(across);
}

/// In one plane with all the edges: the middle of the directions that meet each of them.
std::optional<Vec3> direction_in_plane(const SnapshotCurve &curve, const Vec3 &x) {
    const SnapshotEdge &first = curve.touched[0];
    const Vec3 u = ((first.a + first.b) / 2 - x).normalized(), n = (first.a - x).cross(first.b - x).normalized();
    double low = -std::numbers::pi / 2, high = -low;
    for (const SnapshotEdge &edge : curve.touched) {
        const auto angle = [&](const Vec3 &end) { return std::atan2((end - x).dot(n.cross(u)), (end - x).dot(u)); };
        const auto [from, to] = std::minmax({angle(edge.a), angle(edge.b)});
        low = std::max(low, from);
        high = std::min(high, to);
    }
    if (!(low < high))
        return std::nullopt;
    const double middle = (low + high) / 2;
    return Vec3(std::cos(middle) * u + std::sin(middle) * n.cross(u));
}

/// Unit direction of the line of sight from x: to the corner, or from those two of three edges whose planes through x
/// cross at the largest angle; none where nothing is touched.
std::optional<Vec3> direction(const SnapshotCurve &curve, const Vec3 &x) {
    Vec3 best = Vec3::Zero();
    for (std::size_t i = 0; i < curve.touched.size(); ++i) {
        const SnapshotEdge &one = curve.touched[i];
        if (one.is_corner())
            return (one.a - x).normalized();
        for (std::size_t j = 0; j < i; ++j) {
            const SnapshotEdge &other = curve.touched[j];
            const Vec3 along =
                (one.a - x).cross(one.b - x).normalized().cross((other.a - x).cross(other.b - x).normalized());
            if (along.norm() > best.norm())
                best = along;
        }
    }
    if (!(best.norm() > 1e-6))
        return direction_in_plane(curve, x);
    return Vec3(best.normalized() * (best.dot(curve.touched[0].a - x) > 0 ? 1 : -1));
}

std::vector<Vec3> line_of_sight(const Snapshot &snapshot, const SnapshotCurve &curve, const Vec3 &x) {
    const auto along = direction(curve, x);
    if (!along || !along->allFinite())
        return {};
    std::vector<double> stops{0};
    for (const SnapshotEdge &edge : curve.touched)
        stops.push_back(parameter(x, *along, edge));
    std::ranges::sort(stops);
    const SnapshotSurface &source = snapshot.surfaces[static_cast<std::size_t>(curve.source)];
    const double end = (source.origin - x).dot(source.normal) / along->dot(source.normal);
    stops.push_back(end > stops.back() ? end : stops.back());
    std::vector<Vec3> points;
    for (const double t : stops)
        points.emplace_back(x + t * *along);
    const bool finite = std::ranges::all_of(points, [](const Vec3 &p) { return p.allFinite(); });
    return finite && reaches(source, points.back()) ? points : std::vector<Vec3>();
}

double farthest(const SnapshotSurface &surface, const std::vector<Vec3> &points) {
    double most = 0;
    for (const Vec3 &p : points)
        most = std::max(most, std::abs((p - surface.origin).dot(surface.normal)));
    return most;
}

/// Of source and blockers, the one whose plane the curve lies in.
std::int32_t seen_edge_on(const Snapshot &snapshot, const SnapshotCurve &curve) {
    std::int32_t best = curve.source;
    double least = farthest(snapshot.surfaces[static_cast<std::size_t>(curve.source)], curve.points);
    for (const std::int32_t b : curve.blockers)
        if (const double off = farthest(snapshot.surfaces[static_cast<std::size_t>(b)], curve.points); off < least) {
            best = b;
            least = off;
        }
    return best;
}

/// Convex hull of points of a plane.
std::vector<Vec3> hull(const Vec3 &origin, const Vec3 &u, const Vec3 &v, const std::vector<Vec3> &points) {
    Polygon all;
    for (const Vec3 &p : points)
        all.emplace_back((p - origin).dot(u), (p - origin).dot(v));
    std::vector<Vec3> corners;
    for (const Vec2 &p : convex_hull(all))
        corners.emplace_back(origin + p.x() * u + p.y() * v);
    return corners;
}

std::vector<Vec3> hull_with(const SnapshotSurface &surface, std::vector<Vec3> points) {
    for (const Vec2 &p : surface.outline)
        points.emplace_back(surface.origin + p.x() * surface.u + p.y() * surface.v);
    return hull(surface.origin, surface.u, surface.v, points);
}

/// Of edges that lie in one plane with the curve.
std::vector<Vec3> hull_with(const SnapshotCurve &curve) {
    std::vector<Vec3> points = curve.points;
    for (const SnapshotEdge &edge : curve.touched)
        points.insert(points.end(), {edge.a, edge.b});
    const Vec3 u = (curve.points.back() - curve.points.front()).normalized();
    Vec3 v = Vec3::Zero();
    for (const Vec3 &p : points)
        if (const Vec3 off = (p - curve.points.front()) - (p - curve.points.front()).dot(u) * u; off.norm() > v.norm())
            v = off;
    return hull(curve.points.front(), u, v.normalized(), points);
}

} // namespace

CriticalSurface critical_surface(const Snapshot &snapshot, const SnapshotCurve &curve, int n) {
    CriticalSurface surface;
    if (static_cast<CurveKind>(curve.kind) == CurveKind::plane) {
        surface.edge_on = seen_edge_on(snapshot, curve);
        surface.sheet = hull_with(snapshot.surfaces[static_cast<std::size_t>(surface.edge_on)], curve.points);
    }
    if (curve.touched.size() < 2 || curve.points.size() < 2)
        return surface;
    for (const Vec3 &x : evenly(curve.points, n))
        if (auto sight = line_of_sight(snapshot, curve, x); !sight.empty())
            surface.sights.push_back(std::move(sight));
    const auto is_corner = [](const SnapshotEdge &edge) { return edge.is_corner(); };
    if (surface.sights.empty() && std::ranges::none_of(curve.touched, is_corner))
        surface.sheet = hull_with(curve);
    return surface;
}

std::vector<SnapshotEdge> touched_edges(const Scene &scene, const Curve &curve) {
    std::vector<SurfaceId> owners{curve.source};
    owners.insert(owners.end(), curve.blockers.begin(), curve.blockers.end());
    std::vector<SnapshotEdge> edges;
    for (const TouchedEdge &edge : curve.touched) {
        auto owner = std::ranges::find_if(owners, [&](SurfaceId s) { return on_outline(scene.surface(s), edge); });
        if (owner == owners.end())
            owner = std::ranges::find_if(owners, [&](SurfaceId s) { return in_plane(scene.surface(s), edge); });
        edges.push_back(
            {scene.own.to_own(edge.a), scene.own.to_own(edge.b), owner == owners.end() ? -1 : owner->index});
    }
    return edges;
}

} // namespace penumbra
