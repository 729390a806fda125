#include "scene/covers.h"

#include "core/error.h"
#include "geometry/convex_pieces.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>
#include <utility>

namespace penumbra {

namespace {

struct Box {
    Vec3 low, high;
    bool meets(const Box &o) const {
        return ((low - o.high).maxCoeff() <= coplanar_within) && ((o.low - high).maxCoeff() <= coplanar_within);
    }
};

Box box_of(const Surface &surface) {
    Box box{surface.corners[0], surface.corners[0]};
    for (const Vec3 &x : surface.corners) {
        box.low = box.low.cwiseMin(x);
        box.high = box.high.cwiseMax(x);
    }
    return box;
}

Polygon intersection(Polygon subject, const Polygon &window) {
    Polygon inside, outside;
    for (const HalfPlane &h : half_planes(window)) {
        if (subject.empty())
            break;
        split(subject, h, inside, outside);
        subject.swap(inside);
    }
    return subject;
}

double perimeter(const Polygon &polygon) {
    double sum = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i)
        sum += (polygon[(i + 1) % polygon.size()] - polygon[i]).norm();
    return sum;
}

/// A part of one surface in the plane of another, counter-clockwise there.
Polygon carried_over(const Polygon &part, const PlaneFrame &from, const PlaneFrame &to) {
    Polygon out;
    for (const Vec2 &p : part)
        out.push_back(to.to_plane(from.to_space(p)));
    if (area(out) < 0)
        std::ranges::reverse(out);
    return out;
}

void cover(Surface &below, const Surface &above) {
    for (const Polygon &part : above.parts) {
        const Polygon window = carried_over(part, above.frame, below.frame);
        for (const Polygon &own : below.parts) {
            Polygon piece = intersection(own, window);
            // What only touches leaves a strip as wide as rounding.
            if (piece.size() > 2 && area(piece) > coplanar_within * perimeter(piece))
                below.covers.push_back(std::move(piece));
        }
    }
}

/// Whether the two outlines are one: how OBJ files write a double-sided face, having no word for it.
bool back_to_back(const Surface &a, const Surface &b) {
    const auto has = [](const Surface &s, const Vec3 &x) {
        return std::ranges::any_of(s.corners, [&](const Vec3 &c) { return (c - x).norm() <= coplanar_within; });
    };
    return a.corners.size() == b.corners.size() &&
           std::ranges::all_of(a.corners, [&](const Vec3 &x) { return has(b, x); }) &&
           std::abs(a.area - b.area) <= coplanar_within * perimeter(a.outline);
}

/// Indices i < j, ascending, of surfaces of different faces in one plane whose boxes meet: a sweep along x.
std::vector<std::pair<std::size_t, std::size_t>> coplanar_pairs(const Scene &scene) {
    std::size_t n_parts = 0;
    std::vector<Box> boxes;
    for (const Surface &surface : scene.surfaces)
        boxes.push_back(box_of(surface));
    std::vector<std::size_t> by_x(boxes.size());
    std::iota(by_x.begin(), by_x.end(), std::size_t{0});
    std::ranges::sort(by_x, {}, [&](std::size_t i) { return boxes[i].low.x(); });
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    for (std::size_t k = 0; k < by_x.size(); ++k)
        for (std::size_t l = k + 1; l < by_x.size(); ++l) {
            const Box &a = boxes[by_x[k]], &b = boxes[by_x[l]];
            if (b.low.x() > a.high.x() + coplanar_within)
                break;
            const Surface &s = scene.surfaces[by_x[k]], &t = scene.surfaces[by_x[l]];
            if (!a.meets(b) || s.face == t.face || !in_one_plane(s, t))
                continue;
            if ((n_parts += s.parts.size() * t.parts.size()) > most_coplanar_pairs)
                throw BadInput(
                    fmt::format("{}: too many faces lie on each other in one plane (more than {} pairs of convex "
                                "parts); remove the duplicates",
                                scene.file.string(), most_coplanar_pairs));
            pairs.push_back(std::minmax(by_x[k], by_x[l]));
        }
    std::ranges::sort(pairs);
    return pairs;
}

} // namespace

void find_covers(Scene &scene) {
    for (const auto &[i, j] : coplanar_pairs(scene)) {
        Surface &a = scene.surfaces[i], &b = scene.surfaces[j];
        const bool opposite = a.frame.normal.dot(b.frame.normal) < 0;
        if (opposite && back_to_back(a, b))
            continue;
        const bool a_on_top = scene.emits(SurfaceId(i)) && !scene.emits(SurfaceId(j));
        if (opposite || !a_on_top)
            cover(a, b);
        if (opposite || a_on_top)
            cover(b, a);
    }
}

bool in_one_plane(const Surface &a, const Surface &b) {
    const auto within = [](const Surface &s, const Surface &of) {
        return std::ranges::all_of(s.corners,
                                   [&](const Vec3 &x) { return std::abs(of.frame.height(x)) <= coplanar_within; });
    };
    return std::abs(a.frame.normal.dot(b.frame.normal)) > 0.999 && within(a, b) && within(b, a);
}

bool is_covered(const Surface &surface, const Vec2 &p) {
    return std::ranges::any_of(surface.covers, [&](const Polygon &cover) { return contains(cover, p); });
}

} // namespace penumbra
