#include "discontinuity/source_view.h"

#include "discontinuity/fold.h"
#include "discontinuity/outlines.h"
#include "visibility/shaft.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace penumbra {

namespace {

/// Corners in space of a convex part, taken from the given corners of the outline, of which it is made. Corners that
/// coincide are taken once.
std::vector<Vec3> part_in_space(const Surface &surface, std::span<const Vec3> outline, const Polygon &part) {
    std::vector<Vec3> corners;
    for (const Vec2 &p : part) {
        const auto found = std::ranges::find(surface.outline, p);
        const Vec3 corner = found == surface.outline.end()
                                ? surface.frame.to_space(p)
                                : outline[static_cast<std::size_t>(found - surface.outline.begin())];
        if (corners.empty() || (corner != corners.back() && corner != corners.front()))
            corners.push_back(corner);
    }
    return corners;
}

/// Adds the facet unless welding left it no area.
void add_facet(std::vector<Facet> &facets, SurfaceId id, std::vector<Vec3> corners) {
    if (corners.size() < 3 || newell(corners).norm() <= coincidence * coincidence)
        return;
    const PlaneFrame frame = plane_frame(corners);
    Facet facet{id, std::move(corners), frame, Vec3::Zero(), 0, 0};
    Vec3 low = facet.corners[0], high = low;
    for (const Vec3 &c : facet.corners) {
        low = low.cwiseMin(c);
        high = high.cwiseMax(c);
    }
    facet.centre = (low + high) / 2;
    facet.radius = (high - low).norm() / 2;
    for (const Vec3 &c : facet.corners)
        facet.bend = std::max(facet.bend, std::abs(frame.height(c)));
    facets.push_back(std::move(facet));
}

/// Part of the edge in front of the plane; empty when nothing of it lies truly in front.
Interval part_in_front(const SightEdge &edge, const PlaneFrame &plane) {
    const double a = plane.height(edge.a), b = plane.height(edge.b);
    if (std::max(a, b) <= coincidence)
        return {0, 0};
    if (std::min(a, b) >= -coincidence)
        return {0, 1};
    const double t = a / (a - b);
    return a < b ? Interval{t, 1} : Interval{0, t};
}

bool behind(std::span<const Vec3> corners, const PlaneFrame &plane, double tolerance = coincidence) {
    return std::ranges::all_of(corners, [&](const Vec3 &c) { return plane.height(c) <= tolerance; });
}

} // namespace

std::vector<Vec3> clip_to_front(std::vector<Vec3> polygon, const Vec3 &origin, const Vec3 &normal) {
    std::vector<double> height;
    bool any_front = false, any_behind = false;
    for (const Vec3 &c : polygon) {
        const double h = (c - origin).dot(normal);
        height.push_back(std::abs(h) <= coincidence ? 0 : h);
        any_front |= height.back() > 0;
        any_behind |= height.back() < 0;
    }
    if (!any_front)
        return {};
    if (!any_behind)
        return polygon;
    std::vector<Vec3> front;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const std::size_t j = (i + 1) % polygon.size();
        if (height[i] >= 0)
            front.push_back(polygon[i]);
        if ((height[i] > 0 && height[j] < 0) || (height[i] < 0 && height[j] > 0))
            front.push_back(polygon[i] + height[i] / (height[i] - height[j]) * (polygon[j] - polygon[i]));
    }
    return front;
}

bool face_each_other(const Surface &a, const Surface &b) { return !behind(a.corners, b.frame) && !behind(b.corners, a.frame); }

bool hides(const Surface &blocker, const Surface &receiver, const Surface &source) {
    const auto side = [&](const Vec3 &x) { return blocker.frame.height(x) > 0; };
    const bool front = side(receiver.corners[0]);
    // Most blockers have not even their plane in between.
    if (std::ranges::any_of(receiver.corners, [&](const Vec3 &x) { return side(x) != front; }) ||
        std::ranges::any_of(source.corners, [&](const Vec3 &x) { return side(x) == front; }))
        return false;
    return std::ranges::any_of(blocker.parts, [&](const Polygon &part) {
        return spans_shaft(part_in_space(blocker, blocker.corners, part), blocker.frame, receiver.corners,
                           source.corners);
    });
}

bool share_facet(std::span<const std::size_t> a, std::span<const std::size_t> b) {
    return std::ranges::any_of(a, [&](std::size_t f) { return std::ranges::binary_search(b, f); });
}

bool in_one_plane(const SightEdge &e, const SightEdge &f) {
    constexpr double parallel = 1e-9;
    const Vec3 d = e.b - e.a, g = f.b - f.a, across = d.cross(g);
    const double length = across.norm();
    return length <= parallel * d.norm() * g.norm() || std::abs(across.dot(f.a - e.a)) <= 2 * coincidence * length;
}

bool touches(const Facet &facet, const Vec3 &p) {
    if ((p - facet.centre).squaredNorm() > (facet.radius + coincidence) * (facet.radius + coincidence) ||
        std::abs(facet.frame.height(p)) > coincidence + facet.bend)
        return false;
    const std::size_t n = facet.corners.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Vec3 &a = facet.corners[i];
        const Vec3 edge = facet.corners[(i + 1) % n] - a;
        if (facet.frame.normal.dot(edge.cross(p - a)) < -coincidence * edge.norm())
            return false;
    }
    return true;
}

namespace {

void add_source(SourceView &view, const Surface &lamp, const PlaneFrame &wall) {
    for (const Polygon &part : lamp.parts)
        add_facet(view.source_parts, view.source,
                  clip_to_front(part_in_space(lamp, lamp.corners, part), wall.origin, wall.normal));
    Outlines outline(coincidence, {});
    outline.add(lamp.corners);
    for (const Vec3 &corner : outline.corners())
        if (wall.height(corner) > coincidence)
            view.corners.push_back({corner, {}, true});
    for (const auto &[a, b] : outline.edges()) {
        SightEdge edge{a, b, {0, 1}, {}, true};
        edge.part = part_in_front(edge, wall);
        if (!edge.part.empty())
            view.edges.push_back(edge);
    }
}

/// Where the facet's border runs in the source's plane.
void add_section(Outlines &sections, const Facet &facet, const PlaneFrame &lamp) {
    const std::size_t n = facet.corners.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Vec3 &a = facet.corners[i], &b = facet.corners[(i + 1) % n];
        if (std::abs(lamp.height(a)) <= coincidence && std::abs(lamp.height(b)) <= coincidence)
            sections.add_edge(a, b);
    }
}

/// Where sections cross each other or the source's border: corners of what the source shows, in its plane.
void add_section_crossings(Outlines &sections, std::span<const SightEdge> source_edges, const PlaneFrame &lamp) {
    std::vector<OutlineEdge> edges = sections.edges();
    const std::size_t n_sections = edges.size();
    for (const SightEdge &edge : source_edges)
        edges.push_back({edge.a, edge.b});
    for (std::size_t i = 0; i < n_sections; ++i)
        for (std::size_t j = i + 1; j < edges.size(); ++j) {
            const Vec2 a = lamp.to_plane(edges[i].a), d = lamp.to_plane(edges[i].b) - a;
            const Vec2 b = lamp.to_plane(edges[j].a), e = lamp.to_plane(edges[j].b) - b;
            const double turn = cross(d, e);
            if (std::abs(turn) <= coincidence * d.norm() * e.norm())
                continue;
            const double s = cross(b - a, e) / turn, t = cross(b - a, d) / turn;
            if (s >= 0 && s <= 1 && t >= 0 && t <= 1)
                sections.add_corner(lamp.to_space(a + s * d));
        }
}

void link_facets(SourceView &view) {
    for (std::size_t f = 0; f < view.facets.size(); ++f) {
        const Facet &facet = view.facets[f];
        for (SightCorner &corner : view.corners)
            if (touches(facet, corner.at))
                corner.facets.push_back(f);
        for (SightEdge &edge : view.edges)
            if (!edge.of_source && touches(facet, edge.point(edge.part.middle())) &&
                touches(facet, edge.point(0.9 * edge.part.low + 0.1 * edge.part.high)))
                edge.facets.push_back(f);
    }
}

/// The surfaces among `blockers` that reach into the shaft between the two.
std::vector<SurfaceId> in_shaft(const Scene &scene, const SourceView &view, const Shaft &shaft,
                                std::span<const SurfaceId> blockers) {
    std::vector<SurfaceId> found;
    for (const SurfaceId id : blockers) {
        const std::vector<Vec3> &corners = scene.surface(id).corners;
        if (id != view.source && id != view.receiver && !behind(corners, view.source_plane, weld) &&
            !behind(corners, view.receiver_plane, weld) && !shaft.misses(corners))
            found.push_back(id);
    }
    return found;
}

void add_blockers(SourceView &view, const Scene &scene, std::span<const SurfaceId> blockers, Outlines &outlines) {
    for (const SurfaceId id : blockers) {
        const Surface &blocker = scene.surface(id);
        const std::vector<Vec3> outline = outlines.add(blocker.corners);
        for (const Polygon &part : blocker.parts) {
            std::vector<Vec3> corners = part_in_space(blocker, outline, part);
            for (const PlaneFrame *plane : {&view.source_plane, &view.receiver_plane})
                if (corners.size() > 2)
                    corners = clip_to_front(std::move(corners), plane->origin, plane->normal);
            add_facet(view.facets, id, std::move(corners));
        }
    }
}

/// What covers the source blocks it, lying on it.
void add_covers(SourceView &view, const Surface &lamp) {
    for (const Polygon &cover : lamp.covers) {
        std::vector<Vec3> corners;
        for (const Vec2 &p : cover)
            corners.push_back(lamp.frame.to_space(p));
        add_facet(view.facets, view.source,
                  clip_to_front(std::move(corners), view.receiver_plane.origin, view.receiver_plane.normal));
    }
}

void add_outlines(SourceView &view, const Outlines &outlines, const Shaft &shaft) {
    const PlaneFrame &lamp = view.source_plane, &wall = view.receiver_plane;
    for (const Vec3 &corner : outlines.corners())
        if (lamp.height(corner) > coincidence && wall.height(corner) > coincidence &&
            !shaft.misses(std::span(&corner, 1)))
            view.corners.push_back({corner, {}});
    for (const auto &[a, b] : outlines.edges()) {
        SightEdge edge{a, b, {0, 1}, {}};
        edge.part = overlap(part_in_front(edge, lamp), part_in_front(edge, wall));
        if (!edge.part.empty() && !shaft.misses(std::array{edge.from(), edge.to()}))
            view.edges.push_back(edge);
    }
}

/// Sections lie in the shaft's end, where rounding decides whether they miss it: all of them count.
void add_sections(SourceView &view, const Outlines &sections) {
    for (const Vec3 &corner : sections.corners())
        if (view.receiver_plane.height(corner) > coincidence)
            view.corners.push_back({corner, {}});
    for (const auto &[a, b] : sections.edges()) {
        SightEdge edge{a, b, {0, 1}, {}};
        edge.part = part_in_front(edge, view.receiver_plane);
        if (!edge.part.empty())
            view.edges.push_back(edge);
    }
}

} // namespace

SourceView source_view(const Scene &scene, SurfaceId source, SurfaceId receiver, std::span<const SurfaceId> blockers) {
    const Surface &lamp = scene.surface(source), &wall = scene.surface(receiver);
    SourceView view{source, receiver, lamp.frame, wall.frame, {}, {}, {}, {}};
    if (source == receiver || !face_each_other(wall, lamp))
        return view;
    const Shaft shaft(wall.corners, wall.frame, lamp.corners, lamp.frame);
    const std::vector<SurfaceId> between = in_shaft(scene, view, shaft, blockers);
    if (std::ranges::any_of(between, [&](SurfaceId id) { return hides(scene.surface(id), wall, lamp); }))
        return view;
    add_source(view, lamp, wall.frame);
    const std::vector<SightEdge> source_edges = view.edges;
    Outlines outlines(weld, {lamp.frame, wall.frame}), sections(coincidence, {});
    add_blockers(view, scene, between, outlines);
    add_covers(view, lamp);
    for (const Facet &facet : view.facets)
        add_section(sections, facet, lamp.frame);
    outlines.add_crossings(coincidence);
    add_section_crossings(sections, source_edges, lamp.frame);
    add_outlines(view, outlines, shaft);
    add_sections(view, sections);
    link_facets(view);
    std::erase_if(view.edges, [&](const SightEdge &edge) {
        const auto fold = Fold::make(edge, view.facets);
        return fold && (fold->hides_from(wall.corners) || fold->hides_from(lamp.corners));
    });
    return view;
}

} // namespace penumbra
