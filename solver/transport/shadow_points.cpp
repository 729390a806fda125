#include "transport/shadow_points.h"

#include "geometry/convex_pieces.h"

#include <algorithm>

namespace penumbra {

std::vector<Vec2> shadow_points(const Scene &scene, const Blockers &blockers, const Element &p, const Surface &source,
                                std::span<const PairBlocker> pair) {
    constexpr std::size_t most = 24;
    constexpr double on_plane = 1e-6; // of the unit scene
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
                // The middle of what of this edge's shadow falls on the element.
                double low = 0, high = 1;
                const double above = frame.height(from);
                const double ha = above - frame.height(a), hc = above - frame.height(c);
                if (ha <= 1e-9 || hc <= 1e-9 || frame.height(a) < -on_plane || frame.height(c) < -on_plane)
                    continue;
                // Where a blocker stands on the receiver the transfer jumps: the edge itself has no value to test.
                if (frame.height(a) < on_plane && frame.height(c) < on_plane)
                    continue;
                const Vec2 s = frame.to_plane(from + (above / ha) * (a - from));
                const Vec2 t = frame.to_plane(from + (above / hc) * (c - from));
                for (const HalfPlane &h : half_planes(outline)) {
                    const double vs = h.value(s), vt = h.value(t);
                    if (vs < 0 && vt < 0)
                        high = -1;
                    else if (vs < 0)
                        low = std::max(low, vs / (vs - vt));
                    else if (vt < 0)
                        high = std::min(high, vs / (vs - vt));
                }
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

} // namespace penumbra
