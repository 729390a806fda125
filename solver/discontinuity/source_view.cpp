#include "discontinuity/source_view.h"

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
    Facet facet{id, std::move(corners), Vec3::Zero(), Vec3::Zero(), 0, 0};
    facet.normal = newell(facet.corners).normalized();
    Vec3 low = facet.corners[0], high = low;
    for (const Vec3 &c : facet.corners) {
        low = low.cwiseMin(c);
        high = high.cwiseMax(c);
    }
    facet.centre = (low + high) / 2;
    facet.radius = (high - low).norm() / 2;
    for (const Vec3 &c : facet.corners)
        facet.bend = std::max(facet.bend, std::abs((c - facet.corners[0]).dot(facet.normal)));
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

bool share_facet(std::span<const std::size_t> a, std::span<const std::size_t> b) {
    return std::ranges::any_of(a, [&](std::size_t f) { return std::ranges::binary_search(b, f); });
}

bool touches(const Facet &facet, const Vec3 &p) {
    if ((p - facet.centre).squaredNorm() > (facet.radius + coincidence) * (facet.radius + coincidence) ||
        std::abs((p - facet.corners[0]).dot(facet.normal)) > coincidence + facet.bend)
        return false;
    const std::size_t n = facet.corners.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Vec3 &a = facet.corners[i];
        const Vec3 edge = facet.corners[(i + 1) % n] - a;
        if (facet.normal.dot(edge.cross(p - a)) < -coincidence * edge.norm())
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
            view.source_corners.push_back({corner, {}});
    for (const auto &[a, b] : outline.edges()) {
        SightEdge edge{a, b, {0, 1}, {}};
        edge.part = part_in_front(edge, wall);
        if (!edge.part.empty())
            view.source_edges.push_back(edge);
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
void add_crossings(Outlines &sections, const std::vector<SightEdge> &source_edges, const PlaneFrame &lamp) {
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

/// Whether the edge between two facets is a fold, not a silhouette, for all lines of sight that touch it: these pass
/// from the one side of a facet's plane to the other, and a fold is seen from the sides of which one is inside.
bool always_fold(const SightEdge &edge, const std::vector<Facet> &facets, std::span<const Vec3> receiver,
                 std::span<const Vec3> source) {
    if (edge.facets.size() != 2)
        return false;
    const Vec3 along = (edge.b - edge.a).normalized();
    std::array<Vec3, 2> across;
    for (std::size_t k = 0; k < 2; ++k) {
        const Facet &facet = facets[edge.facets[k]];
        Vec3 middle = Vec3::Zero();
        for (const Vec3 &c : facet.corners)
            middle += c / static_cast<double>(facet.corners.size());
        const Vec3 inwards = (middle - edge.a) - (middle - edge.a).dot(along) * along;
        across[k] = along.cross(inwards).normalized();
    }
    const auto side = [&](std::span<const Vec3> points, const Vec3 &normal) {
        constexpr double clear = 2 * weld;
        const auto height = [&](const Vec3 &p) { return (p - edge.a).dot(normal); };
        if (std::ranges::all_of(points, [&](const Vec3 &p) { return height(p) > clear; }))
            return 1;
        return std::ranges::all_of(points, [&](const Vec3 &p) { return height(p) < -clear; }) ? -1 : 0;
    };
    return side(receiver, across[0]) * side(receiver, across[1]) < 0 ||
           side(source, across[0]) * side(source, across[1]) < 0;
}

void link_facets(SourceView &view, std::vector<SightEdge> &edges, std::vector<SightCorner> &corners) {
    for (std::size_t f = 0; f < view.facets.size(); ++f) {
        const Facet &facet = view.facets[f];
        for (SightCorner &corner : corners)
            if (touches(facet, corner.at))
                corner.facets.push_back(f);
        for (SightEdge &edge : edges)
            if (touches(facet, edge.point(edge.part.middle())) && touches(facet, edge.point(0.9 * edge.part.low + 0.1 * edge.part.high)))
                edge.facets.push_back(f);
    }
}

} // namespace

SourceView source_view(const Scene &scene, SurfaceId source, SurfaceId receiver, std::span<const SurfaceId> blockers) {
    SourceView view;
    view.source = source;
    view.receiver = receiver;
    const Surface &lamp = scene.surface(source), &wall = scene.surface(receiver);
    view.source_plane = lamp.frame;
    view.receiver_plane = wall.frame;
    if (source == receiver || behind(wall.corners, lamp.frame) || behind(lamp.corners, wall.frame))
        return view;
    add_source(view, lamp, wall.frame);

    const Shaft shaft(wall.corners, wall.frame, lamp.corners, lamp.frame);
    Outlines outlines(weld, {lamp.frame, wall.frame}), sections(coincidence, {});
    for (const SurfaceId id : blockers) {
        const Surface &blocker = scene.surface(id);
        if (id == source || id == receiver || behind(blocker.corners, lamp.frame, weld) ||
            behind(blocker.corners, wall.frame, weld) || shaft.misses(blocker.corners))
            continue;
        const std::vector<Vec3> outline = outlines.add(blocker.corners);
        for (const Polygon &part : blocker.parts) {
            std::vector<Vec3> corners = part_in_space(blocker, outline, part);
            if (corners.size() > 2)
                corners = clip_to_front(std::move(corners), lamp.frame.origin, lamp.frame.normal);
            if (corners.size() > 2)
                corners = clip_to_front(std::move(corners), wall.frame.origin, wall.frame.normal);
            const std::size_t before = view.facets.size();
            add_facet(view.facets, id, std::move(corners));
            if (view.facets.size() == before)
                continue;
            const Facet &facet = view.facets.back();
            if (spans_shaft(facet.corners, plane_frame(facet.corners), wall.corners, lamp.corners)) {
                view.source_parts.clear();
                return view;
            }
            add_section(sections, facet, lamp.frame);
        }
    }
    for (const Polygon &cover : lamp.covers) {
        std::vector<Vec3> corners;
        for (const Vec2 &p : cover)
            corners.push_back(lamp.frame.to_space(p));
        const std::size_t before = view.facets.size();
        add_facet(view.facets, source, clip_to_front(std::move(corners), wall.frame.origin, wall.frame.normal));
        if (view.facets.size() > before)
            add_section(sections, view.facets.back(), lamp.frame);
    }
    add_crossings(sections, view.source_edges, lamp.frame);
    for (const Vec3 &corner : outlines.corners())
        if (lamp.frame.height(corner) > coincidence && wall.frame.height(corner) > coincidence &&
            !shaft.misses(std::span(&corner, 1)))
            view.blocker_corners.push_back({corner, {}});
    for (const Vec3 &corner : sections.corners())
        if (wall.frame.height(corner) > coincidence)
            view.blocker_corners.push_back({corner, {}});
    for (const Outlines *from : {&outlines, &sections})
        for (const auto &[a, b] : from->edges()) {
            SightEdge edge{a, b, {0, 1}, {}};
            edge.part = from == &outlines ? overlap(part_in_front(edge, lamp.frame), part_in_front(edge, wall.frame))
                                          : part_in_front(edge, wall.frame);
            // A section lies in the shaft's end: rounding decides whether it misses the shaft.
            if (!edge.part.empty() && (from == &sections || !shaft.misses(std::array{edge.from(), edge.to()})))
                view.blocker_edges.push_back(edge);
        }
    link_facets(view, view.blocker_edges, view.blocker_corners);
    std::vector<SightEdge> no_edges;
    link_facets(view, no_edges, view.source_corners);
    std::erase_if(view.blocker_edges, [&](const SightEdge &edge) {
        return always_fold(edge, view.facets, wall.corners, lamp.corners);
    });
    return view;
}

} // namespace penumbra
