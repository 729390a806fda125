#include "geometry/convex_pieces.h"

#include <algorithm>

namespace penumbra {

double ConvexPieces::area() const {
    double sum = 0;
    for (std::size_t i = 0; i < size(); ++i)
        sum += penumbra::area((*this)[i]);
    return sum;
}

void split(std::span<const Vec2> convex, const HalfPlane &h, Polygon &inside, Polygon &outside) {
    inside.clear();
    outside.clear();
    if (convex.empty())
        return;
    Vec2 previous = convex.back();
    double before = h.value(previous);
    bool any_inside = false, any_outside = false;
    for (const Vec2 &p : convex) {
        const double now = h.value(p);
        if ((before > 0 && now < 0) || (before < 0 && now > 0)) {
            const Vec2 crossing = previous + (before / (before - now)) * (p - previous);
            inside.push_back(crossing);
            outside.push_back(crossing);
        }
        if (now >= 0)
            inside.push_back(p);
        if (now <= 0)
            outside.push_back(p);
        any_inside |= now > 0;
        any_outside |= now < 0;
        previous = p;
        before = now;
    }
    if (!any_inside && any_outside)
        inside.clear();
    if (!any_outside)
        outside.clear();
}

void clip(const ConvexPieces &pieces, const HalfPlane &h, ConvexPieces &out) {
    out.clear();
    thread_local Polygon inside, outside;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        split(pieces[i], h, inside, outside);
        if (inside.size() > 2)
            out.add(inside);
    }
}

void subtract(const ConvexPieces &pieces, std::span<const HalfPlane> region, ConvexPieces &out) {
    out.clear();
    thread_local Polygon rest, inside, outside;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const std::span<const Vec2> piece = pieces[i];
        const bool missed = std::ranges::any_of(region, [&](const HalfPlane &h) {
            return std::ranges::all_of(piece, [&](const Vec2 &p) { return h.value(p) <= 0; });
        });
        if (missed) {
            out.add(piece);
            continue;
        }
        rest.assign(piece.begin(), piece.end());
        for (const HalfPlane &h : region) {
            split(rest, h, inside, outside);
            if (outside.size() > 2)
                out.add(outside);
            rest.swap(inside);
            if (rest.size() < 3)
                break;
        }
    }
}

std::vector<HalfPlane> half_planes(std::span<const Vec2> convex) {
    std::vector<HalfPlane> out;
    for (std::size_t i = 0; i < convex.size(); ++i) {
        const Vec2 &p = convex[i];
        const Vec2 edge = convex[(i + 1) % convex.size()] - p;
        out.push_back({-edge.y(), edge.x(), edge.y() * p.x() - edge.x() * p.y()});
    }
    return out;
}

} // namespace penumbra
