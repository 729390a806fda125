#include "transport/shadow_points.h"

#include "geometry/convex_pieces.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

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

/// What the blocker has in common with the plane that it stands on or goes through.
std::optional<std::pair<Vec2, Vec2>> contact_of(const Blocker &blocker, const PlaneFrame &plane) {
    const std::size_t n = blocker.corners.size();
    std::vector<Vec2> ends;
    for (std::size_t i = 0; i < n; ++i) {
        const Vec3 &a = blocker.corners[i], &c = blocker.corners[(i + 1) % n];
        const double ha = plane.height(a), hc = plane.height(c);
        if (std::abs(ha) < on_plane)
            ends.push_back(plane.to_plane(a));
        else if (std::abs(hc) >= on_plane && (ha < 0) != (hc < 0))
            ends.push_back(plane.to_plane(a + ha / (ha - hc) * (c - a)));
    }
    return ends.size() == 2 ? std::optional(std::pair(ends[0], ends[1])) : std::nullopt;
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
    const double beside = 1e-3 * radius(outline);
    std::vector<Vec2> found;
    Polygon left, right;
    for (const PairBlocker &b : pair) {
        const auto contact = contact_of(blockers[b.blocker], frame);
        if (!contact)
            continue;
        const auto &[s, t] = *contact;
        const auto [low, high] = part_inside(borders, s, t);
        if (low >= high)
            continue;
        split(outline, {s.y() - t.y(), t.x() - s.x(), cross(s, t)}, left, right);
        if (narrow(left) || narrow(right))
            continue;
        found.push_back(centroid(left));
        found.push_back(centroid(right));
        const Vec2 middle = s + (low + high) / 2 * (t - s), along = (t - s).normalized(), across(-along.y(), along.x());
        for (const Vec2 &at : {Vec2(middle + beside * across), Vec2(middle - beside * across)})
            if (contains(outline, at))
                found.push_back(at);
    }
    return found;
}

} // namespace penumbra
