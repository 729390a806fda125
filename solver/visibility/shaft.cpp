#include "visibility/shaft.h"

#include "geometry/polygon.h"

#include <algorithm>

namespace penumbra {

namespace {
constexpr double touch = 1e-12;
}

Shaft::Shaft(std::span<const Vec3> receiver, const PlaneFrame &receiver_frame, std::span<const Vec3> source,
             const PlaneFrame &source_frame)
    : low_(receiver[0]), high_(receiver[0]) {
    for (const auto polygon : {receiver, source})
        for (const Vec3 &x : polygon) {
            low_ = low_.cwiseMin(x);
            high_ = high_.cwiseMax(x);
        }
    planes_.push_back({-receiver_frame.normal, -receiver_frame.normal.dot(receiver_frame.origin)});
    planes_.push_back({-source_frame.normal, -source_frame.normal.dot(source_frame.origin)});
    const auto side_planes = [&](std::span<const Vec3> edges, std::span<const Vec3> corners) {
        for (std::size_t i = 0; i < edges.size(); ++i) {
            const Vec3 &a = edges[i], &b = edges[(i + 1) % edges.size()];
            for (const Vec3 &c : corners) {
                Vec3 normal = (b - a).cross(c - a);
                const double length = normal.norm();
                if (length < 1e-14)
                    continue;
                normal /= length;
                double least = 0, most = 0;
                for (const auto polygon : {edges, corners})
                    for (const Vec3 &x : polygon) {
                        const double h = normal.dot(x - a);
                        least = std::min(least, h);
                        most = std::max(most, h);
                    }
                if (most <= touch)
                    planes_.push_back({normal, normal.dot(a) + most});
                else if (least >= -touch)
                    planes_.push_back({-normal, -normal.dot(a) - least});
            }
        }
    };
    side_planes(receiver, source);
    side_planes(source, receiver);
}

bool Shaft::misses(std::span<const Vec3> polygon, double gap) const {
    return std::ranges::any_of(planes_, [&](const Plane &p) {
        return std::ranges::all_of(polygon, [&](const Vec3 &x) { return p.normal.dot(x) - p.offset >= gap; });
    });
}

std::pair<double, double> Shaft::part_inside(const Vec3 &p, const Vec3 &q, double slack) const {
    double low = 0, high = 1;
    for (const Plane &plane : planes_) {
        const double a = plane.normal.dot(p) - plane.offset - slack, b = plane.normal.dot(q) - plane.offset - slack;
        if (a > 0 && b > 0)
            return {1, 0};
        if (a > 0)
            low = std::max(low, a / (a - b));
        else if (b > 0)
            high = std::min(high, a / (a - b));
    }
    return {low, high};
}

bool spans_shaft(std::span<const Vec3> blocker, const PlaneFrame &frame, std::span<const Vec3> receiver,
                 std::span<const Vec3> source) {
    constexpr double margin = 1e-9;
    const auto height = [&](const Vec3 &x) { return frame.height(x); };
    const bool front = std::ranges::all_of(receiver, [&](const Vec3 &x) { return height(x) > margin; }) &&
                       std::ranges::all_of(source, [&](const Vec3 &x) { return height(x) < -margin; });
    const bool back = std::ranges::all_of(receiver, [&](const Vec3 &x) { return height(x) < -margin; }) &&
                      std::ranges::all_of(source, [&](const Vec3 &x) { return height(x) > margin; });
    if (!front && !back)
        return false;
    Polygon outline;
    for (const Vec3 &x : blocker)
        outline.push_back(frame.to_plane(x));
    return std::ranges::all_of(receiver, [&](const Vec3 &x) {
        const double hx = height(x);
        return std::ranges::all_of(source, [&](const Vec3 &y) {
            const double hy = height(y);
            return contains(outline, frame.to_plane(x + (hx / (hx - hy)) * (y - x)));
        });
    });
}

} // namespace penumbra
