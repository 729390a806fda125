#include "transport/shadow_points.h"

#include "geometry/convex_pieces.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace penumbra {

namespace {

constexpr std::size_t most = 24;
constexpr double on_plane = 1e-6; // of the unit scene

/// The middle of what of the segment from s to t lies in the convex polygon.
std::optional<Vec2> middle_inside(const Polygon &convex, const Vec2 &s, const Vec2 &t) {
    double low = 0, high = 1;
    for (const HalfPlane &h : half_planes(convex)) {
        const double vs = h.value(s), vt = h.value(t);
        if (vs < 0 && vt < 0)
            return std::nullopt;
        if (vs < 0)
            low = std::max(low, vs / (vs - vt));
        else if (vt < 0)
            high = std::min(high, vs / (vs - vt));
    }
    return low < high ? std::optional<Vec2>(s + (low + high) / 2 * (t - s)) : std::nullopt;
}

/// Both sides of the lines along which blockers go through p.
std::vector<Vec2> contact_points(const PlaneFrame &frame, const Polygon &outline, const Blockers &blockers,
                                 std::span<const PairBlocker> pair) {
    std::vector<Vec2> found;
    const double beside = 1e-3 * radius(outline);
    for (const PairBlocker &b : pair) {
        const auto &corners = blockers[b.blocker].corners;
        std::vector<Vec2> ends;
        bool pierces = false;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Vec3 &a = corners[i], &c = corners[(i + 1) % corners.size()];
            const double ha = frame.height(a), hc = frame.height(c);
            pierces |= ha < -on_plane;
            if ((ha < 0) != (hc < 0))
                ends.push_back(frame.to_plane(a + ha / (ha - hc) * (c - a)));
        }
        if (!pierces || ends.size() != 2)
            continue;
        const auto middle = middle_inside(outline, ends[0], ends[1]);
        if (!middle)
            continue;
        const Vec2 along = (ends[1] - ends[0]).normalized(), across(-along.y(), along.x());
        for (const Vec2 &at : {Vec2(*middle + beside * across), Vec2(*middle - beside * across)})
            if (contains(outline, at))
                found.push_back(at);
    }
    return found;
}

std::vector<Vec2> thinned(std::vector<Vec2> points) {
    if (points.size() <= most)
        return points;
    for (std::size_t i = 0; i < most; ++i)
        points[i] = points[i * points.size() / most];
    points.resize(most);
    return points;
}

} // namespace

std::vector<Vec2> shadow_points(const Scene &scene, const Blockers &blockers, const Element &p, const Surface &source,
                                std::span<const PairBlocker> pair) {
    const PlaneFrame &frame = scene.surface(p.surface).frame;
    const Polygon &outline = p.basis.outline();
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
            for (const Vec3 &from : source.corners) {
                const double above = frame.height(from);
                const double ha = above - frame.height(a), hc = above - frame.height(c);
                if (ha <= 1e-9 || hc <= 1e-9 || frame.height(a) < -on_plane || frame.height(c) < -on_plane)
                    continue;
                // Where a blocker stands on the receiver the transfer jumps: the edge itself has no value to test.
                if (frame.height(a) < on_plane && frame.height(c) < on_plane)
                    continue;
                const Vec2 s = frame.to_plane(from + (above / ha) * (a - from));
                const Vec2 t = frame.to_plane(from + (above / hc) * (c - from));
                if (const auto inside = middle_inside(outline, s, t))
                    add(*inside);
            }
        }
    }
    found = thinned(std::move(found));
    const std::vector<Vec2> contacts = thinned(contact_points(frame, outline, blockers, pair));
    found.insert(found.end(), contacts.begin(), contacts.end());
    return found;
}

} // namespace penumbra
