#include "iteration/profile.h"

#include "core/parallel.h"
#include "geometry/polygon.h"

#include <algorithm>
#include <cmath>

namespace penumbra {

namespace {

/// The part of the line a + t (b - a), t in [0, 1], inside a convex polygon; empty where low >= high.
struct Part {
    double low = 0, high = 1;
};

Part inside(const std::vector<Vec2> &polygon, const Vec2 &a, const Vec2 &b) {
    Part part;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vec2 &p = polygon[k], side = polygon[(k + 1) % polygon.size()] - p;
        const double before = cross(side, a - p), after = cross(side, b - p), way = before - after;
        if (std::abs(way) <= 1e-14 * side.norm() * (b - a).norm()) {
            if (before < 0)
                part.high = -1;
        } else if (way < 0) {
            part.low = std::max(part.low, before / way);
        } else {
            part.high = std::min(part.high, before / way);
        }
    }
    return part;
}

/// Distance of a point from the surface: of its plane, where the foot lies inside.
double distance(const SnapshotSurface &s, const Vec3 &p, double slack) {
    const double height = std::abs((p - s.origin).dot(s.normal));
    const Vec2 foot = to_plane(s, p);
    if (holds(s, foot))
        return height;
    double nearest = 1e300;
    for (std::size_t k = 0; k < s.outline.size(); ++k) {
        const Vec2 &a = s.outline[k], side = s.outline[(k + 1) % s.outline.size()] - a;
        const double t = std::clamp((foot - a).dot(side) / side.squaredNorm(), 0.0, 1.0);
        nearest = std::min(nearest, (a + t * side - foot).norm());
    }
    return nearest <= slack ? std::max(height, nearest) : 1e300;
}

} // namespace

std::optional<ProfileLine> line_over(const Snapshot &snapshot, const Vec3 &from, const Vec3 &to, double slack) {
    std::optional<ProfileLine> best;
    double nearest = slack;
    for (std::size_t i = 0; i < snapshot.surfaces.size(); ++i) {
        const SnapshotSurface &s = snapshot.surfaces[i];
        if (s.reflectance.maxCoeff() <= 0)
            continue;
        const double off = std::max(distance(s, from, slack), distance(s, to, slack));
        if (off > nearest || (best && off == nearest))
            continue;
        nearest = off;
        const auto foot = [&](const Vec3 &p) { return Vec3(p - (p - s.origin).dot(s.normal) * s.normal); };
        best = ProfileLine{static_cast<int>(i), foot(from), foot(to)};
    }
    return best && best->length() > 1e-9 * slack ? best : std::nullopt;
}

std::vector<ProfilePiece> profile(const Snapshot &snapshot, const ProfileLine &line, int n) {
    const SnapshotSurface &surface = snapshot.surfaces[static_cast<std::size_t>(line.surface)];
    const Vec2 a = to_plane(surface, line.from), b = to_plane(surface, line.to), direction = (b - a).normalized();
    const double length = line.length();
    std::vector<ProfilePiece> pieces;
    for (std::size_t i = 0; i < snapshot.patches.size(); ++i) {
        const SnapshotPatch &patch = snapshot.patches[i];
        if (patch.surface != line.surface)
            continue;
        const Part part = inside(patch.corners, a, b);
        if (part.high - part.low <= 1e-9)
            continue;
        ProfilePiece piece{static_cast<int>(i), part.low * length, part.high * length, {}};
        const int m = std::max(patch.order == 1 ? 1 : 2, static_cast<int>(std::ceil((part.high - part.low) * n)));
        for (int k = 0; k <= m; ++k) {
            const double t = part.low + (part.high - part.low) * k / m;
            const Vec2 p = a + t * (b - a);
            piece.points.push_back(
                {t * length, radiosity(snapshot, patch, p), radiosity_slope(snapshot, patch, p, direction)});
        }
        pieces.push_back(std::move(piece));
    }
    std::ranges::sort(pieces, {}, &ProfilePiece::low);
    // A line along a common side of patches lies in both of them: the first is as good as the other.
    std::vector<ProfilePiece> apart;
    for (ProfilePiece &piece : pieces)
        if (apart.empty() || piece.high > apart.back().high + 1e-9 * length)
            apart.push_back(std::move(piece));
    return apart;
}

std::vector<ProfilePoint> true_profile(const Truth &truth, const SnapshotSurface &surface, const ProfileLine &line,
                                       int n, std::span<const double> breaks, const Cancel *cancel) {
    const double length = line.length(), step = difference_step() * length;
    std::vector<ProfilePoint> points;
    const auto add = [&](double at) { points.push_back({std::clamp(at, 0.0, length), Rgb::Zero(), Rgb::Zero()}); };
    for (int k = 0; k <= n; ++k)
        add(length * k / n);
    for (const double at : breaks)
        for (const double beside : {-1e-6 * length, 1e-6 * length})
            add(at + beside);
    std::ranges::sort(points, {}, &ProfilePoint::at);
    const Vec2 a = to_plane(surface, line.from), direction = (to_plane(surface, line.to) - a).normalized();
    const auto value = [&](double at) -> Rgb {
        const Vec2 p = a + at * direction;
        return is_covered(surface, p) ? Rgb(Rgb::Zero()) : truth.radiosity_at(line.surface, p);
    };
    parallel_for(points.size(), [&](std::size_t i) {
        if (cancel)
            cancel->check();
        ProfilePoint &p = points[i];
        const double low = std::max(0.0, p.at - step), high = std::min(length, p.at + step);
        p.radiosity = value(p.at);
        p.slope = (value(high) - value(low)) / (high - low);
    });
    return points;
}

} // namespace penumbra
