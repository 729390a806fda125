#include "transport/shadow_points.h"

#include "geometry/convex_pieces.h"

#include <algorithm>

namespace penumbra {

namespace {

constexpr double on_plane = 1e-6;     // of the unit scene
constexpr double least_width = 0.005; // of the element's radius: what a contact has to part from it

/// The parameters of the part of the segment from s to t inside the convex polygon; high < low when there is none.
std::pair<double, double> part_inside(std::span<const HalfPlane> borders, const Vec2 &s, const Vec2 &t) {
    double low = 0, high = 1;
    for (const HalfPlane &h : borders) {
        const double vs = h.value(s), vt = h.value(t);
        if (vs < 0 && vt < 0)
            high = -1;
        else if (vs < 0)
            low = std::max(low, vs / (vs - vt));
        else if (vt < 0)
            high = std::min(high, vs / (vs - vt));
    }
    return {low, high};
}

} // namespace

std::vector<Vec2> shadow_points(const Scene &scene, const Blockers &blockers, const Element &p, const Surface &source,
                                std::span<const PairBlocker> pair) {
    constexpr std::size_t most = 24;
    const PlaneFrame &frame = scene.surface(p.surface).frame;
    const Polygon &outline = p.basis.outline();
    const std::vector<HalfPlane> borders = half_planes(outline);
    std::vector<Vec2> found;
    const Vec2 middle_of_p = p.basis.centre();
    const auto add = [&](const Vec2 &at) { found.push_back(at + 0.02 * (middle_of_p - at)); };
    const auto project = [&](const Vec3 &from, const Vec3 &through) {
        const double above = frame.height(from), between = frame.height(through);
        if (between <= 0 || above <= between)
            return;
        const Vec2 at = frame.to_plane(from + (above / (above - between)) * (through - from));
        if (contains(outline, at))
            add(at);
    };
    const Vec3 centre = source.frame.to_space(centroid(source.outline));
    for (const PairBlocker &b : pair) {
        const auto &corners = blockers[b.blocker].corners;
        Vec3 middle = Vec3::Zero();
        for (const Vec3 &c : corners)
            middle += c / static_cast<double>(corners.size());
        project(centre, middle);
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Vec3 &a = corners[i], &c = corners[(i + 1) % corners.size()];
            if (std::abs(frame.height(a)) < on_plane && std::abs(frame.height(c)) < on_plane)
                continue; // the transfer jumps there: contact_points
            for (const Vec3 &from : source.corners) {
                // The middle of what of this edge's shadow falls on the element.
                const double above = frame.height(from);
                const double ha = above - frame.height(a), hc = above - frame.height(c);
                if (ha <= 1e-9 || hc <= 1e-9 || frame.height(a) < -on_plane || frame.height(c) < -on_plane)
                    continue;
                const Vec2 s = frame.to_plane(from + (above / ha) * (a - from));
                const Vec2 t = frame.to_plane(from + (above / hc) * (c - from));
                const auto [low, high] = part_inside(borders, s, t);
                if (low < high)
                    add(s + (low + high) / 2 * (t - s));
            }
        }
    }
    if (found.size() <= most)
        return found;
    std::vector<Vec2> thinned;
    for (std::size_t i = 0; i < most; ++i)
        thinned.push_back(found[i * found.size() / most]);
    return thinned;
}

std::vector<Vec2> contact_points(const Scene &scene, const Blockers &blockers, const Element &p,
                                 std::span<const PairBlocker> pair) {
    const PlaneFrame &frame = scene.surface(p.surface).frame;
    const Polygon &outline = p.basis.outline();
    const std::vector<HalfPlane> borders = half_planes(outline);
    const auto narrow = [least = least_width * radius(outline)](const Polygon &part) {
        return part.size() < 3 || area(part) < least * 2 * radius(part);
    };
    std::vector<Vec2> found;
    Polygon left, right;
    for (const PairBlocker &b : pair) {
        const auto &corners = blockers[b.blocker].corners;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Vec3 &a = corners[i], &c = corners[(i + 1) % corners.size()];
            if (std::abs(frame.height(a)) >= on_plane || std::abs(frame.height(c)) >= on_plane)
                continue;
            const Vec2 s = frame.to_plane(a), t = frame.to_plane(c);
            if (const auto [low, high] = part_inside(borders, s, t); low >= high)
                continue;
            split(outline, {s.y() - t.y(), t.x() - s.x(), cross(s, t)}, left, right);
            if (narrow(left) || narrow(right))
                continue;
            found.push_back(centroid(left));
            found.push_back(centroid(right));
        }
    }
    return found;
}

} // namespace penumbra
