#include "discontinuity/trace_edges.h"

#include "discontinuity/crossing.h"
#include "discontinuity/edge_on.h"
#include "discontinuity/local_picture.h"
#include "discontinuity/receiver_line.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>

namespace penumbra {

namespace {

/// The plane through both edges; none when they lie in one line or do not rise over the receiver.
std::optional<Wedge> plane_through(const SightEdge &e, const SightEdge &f, const PlaneFrame &receiver) {
    struct Choice {
        Vec3 apex;
        const SightEdge *edge;
    };
    const std::array<Choice, 4> choices{{{e.from(), &f}, {e.to(), &f}, {f.from(), &e}, {f.to(), &e}}};
    const auto width = [&](const Choice &c) {
        return receiver.height(c.apex) > coincidence ? (c.edge->a - c.apex).cross(c.edge->b - c.apex).norm() : 0;
    };
    const Choice &best = *std::ranges::max_element(choices, {}, width);
    auto plane = make_wedge(best.apex, best.edge->a, best.edge->b, receiver);
    if (plane)
        plane->slack = 4 * coincidence;
    return plane;
}

/// The line's points that lie in line with a point of either edge; all where the edges are partly as high as each other.
Interval in_line_with(const Polygon &e, const Polygon &f) {
    const auto [e_low, e_high] = std::minmax(e[0].y(), e[1].y());
    const auto [f_low, f_high] = std::minmax(f[0].y(), f[1].y());
    if (e_low <= f_high + coincidence && f_low <= e_high + coincidence)
        return {};
    Interval hull{Interval{}.high, Interval{}.low};
    for (const Vec2 &p : e)
        for (const Vec2 &q : f) {
            const double at = p.x() - p.y() / (q.y() - p.y()) * (q.x() - p.x());
            hull = {std::min(hull.low, at), std::max(hull.high, at)};
        }
    return hull;
}

constexpr double never = Interval{}.high;

class EdgesTracer {
public:
    EdgesTracer(const SourceView &view, const Wedge &plane, const SightEdge &e, const SightEdge &f,
                std::span<const std::size_t> facets)
        : view_(view), plane_(plane), e_{flattened(plane, {e.from(), e.to()})},
          f_{flattened(plane, {f.from(), f.to()})}, flat_(edge_on_scene(view, facets, plane)) {
        points_ = points_of(flat_);
        points_.insert(points_.end(), e_[0].begin(), e_[0].end());
        points_.insert(points_.end(), f_[0].begin(), f_[0].end());
        for (const std::size_t i : facets)
            if (const Facet &facet = view.facets[i];
                std::abs(plane.height(facet.centre)) <= facet.radius + plane.slack)
                add_grazed(facet);
    }

    Interval range() const { return in_line_with(e_[0], f_[0]); }

    /// What bounds the visible part along both edges, by pieces of the line; pieces that see nothing happen are left out.
    template <class Emit>
    void run(IntervalSet line, const Emit &emit) const {
        if (flat_.targets.empty())
            return;
        keep_open(line);
        split_between(points_, line);
        std::optional<std::vector<SurfaceId>> growing;
        Interval whole;
        for (const Interval &piece : line.intervals()) {
            auto blockers = real_blockers(piece.middle());
            if (growing && growing == blockers && piece.low <= whole.high) {
                whole.high = piece.high;
                continue;
            }
            if (growing)
                emit(whole, *growing);
            growing = std::move(blockers);
            whole = piece;
        }
        if (growing)
            emit(whole, *growing);
    }

private:
    /// Distance at which the ray has passed both edges on its way to the source; infinite when it does not.
    double passed(const Vec2 &x, const Vec2 &direction) const {
        const double edges = std::max(first_hit(e_, x, direction), first_hit(f_, x, direction));
        const double target = edges == never ? never : first_hit(flat_.targets, x, direction);
        return target != never && edges <= target + 2 * coincidence ? target : never;
    }

    /// Most lines see nothing of the source past both edges, whatever else stands there: only the others pay for the many
    /// points of that.
    void keep_open(IntervalSet &line) const {
        std::vector<Vec2> few;
        for (const Polygon *edge : {&e_[0], &f_[0]})
            few.insert(few.end(), edge->begin(), edge->end());
        for (const Polygon &target : flat_.targets)
            few.insert(few.end(), target.begin(), target.end());
        split_between(few, line);
        const IntervalSet pieces = line;
        for (const Interval &piece : pieces.intervals()) {
            const Vec2 x(piece.middle(), 0);
            if (std::ranges::none_of(directions_between(few, x),
                                     [&](const Vec2 &direction) { return passed(x, direction) != never; }))
                line.subtract(piece);
        }
    }

    void add_grazed(const Facet &facet) {
        const Crossing crossing = cross_facet(plane_, facet);
        if (crossing.n < 2 || crossing.through())
            return;
        grazed_.push_back(&facet);
        const Polygon border =
            flattened(plane_, crossing.along_edge() ? std::vector<Vec3>{crossing.p, crossing.q} : facet.corners);
        points_.insert(points_.end(), border.begin(), border.end());
    }

    std::optional<std::vector<SurfaceId>> real_blockers(double s) const {
        const Vec2 x(s, 0);
        std::vector<SurfaceId> all;
        for (const Vec2 &direction : directions_between(points_, x)) {
            const double target = passed(x, direction);
            if (target == never || first_hit(flat_.blockers, x, direction) < target)
                continue;
            if (const auto blockers = bounding(s, direction))
                all.insert(all.end(), blockers->begin(), blockers->end());
        }
        if (all.empty())
            return std::nullopt;
        std::ranges::sort(all);
        const auto twins = std::ranges::unique(all);
        all.erase(twins.begin(), twins.end());
        return all;
    }

    std::optional<std::vector<SurfaceId>> bounding(double s, const Vec2 &direction) const {
        const Vec3 side = plane_.normal.cross(plane_.along), up = side.dot(plane_.receiver.normal) > 0 ? side : -side;
        const SightLine eye{plane_.on_receiver(s), (direction.x() * plane_.along + direction.y() * up).normalized()};
        LocalPicture picture(eye, plane_.receiver.normal.cross(plane_.along));
        for (const Facet &part : view_.source_parts)
            picture.add_source(part);
        for (const Facet *facet : grazed_)
            if (picture.add_blocker(*facet) == Meeting::pierced)
                return std::nullopt;
        return picture.strips_change(plane_.normal.cross(eye.along)) ? std::optional(picture.bounding()) : std::nullopt;
    }

    const SourceView &view_;
    const Wedge &plane_;
    std::array<Polygon, 1> e_, f_;
    EdgeOnScene flat_;
    std::vector<const Facet *> grazed_;
    std::vector<Vec2> points_;
};

} // namespace

void trace_edges(const Scene &scene, const SourceView &view, const SightCells &cells, std::vector<Curve> &curves) {
    for (const Encounter &encounter : cells.edges_in_plane()) {
        const SightEdge &e = view.edges[encounter.touched[0]], &f = view.edges[encounter.touched[1]];
        const auto plane = plane_through(e, f, view.receiver_plane);
        if (!plane)
            continue;
        IntervalSet line = cells.line_inside(encounter, plane->foot, plane->along);
        line.clip(lit_part(scene, view, plane->foot, plane->along));
        if (line.empty())
            continue;
        const EdgesTracer tracer(view, *plane, e, f, cells.facets(encounter));
        line.clip(tracer.range());
        line.drop_shorter(shortest_curve);
        const auto at = [&](double s) { return view.receiver_plane.to_plane(plane->on_receiver(s)); };
        tracer.run(std::move(line), [&](const Interval &part, const std::vector<SurfaceId> &blockers) {
            if (part.length() >= shortest_curve)
                curves.push_back({CurveKind::ve, 1, view.source, view.receiver, blockers, at(part.low), at(part.high),
                                  Vec3::Zero(), {{e.from(), e.to()}, {f.from(), f.to()}}});
        });
    }
}

} // namespace penumbra
