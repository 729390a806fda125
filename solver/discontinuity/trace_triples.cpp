#include "discontinuity/trace_triples.h"

#include "discontinuity/local_picture.h"
#include "discontinuity/receiver_line.h"
#include "discontinuity/regulus.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace penumbra {

namespace {

using Triple = std::array<const SightEdge *, 3>;

class TripleTracer {
public:
    TripleTracer(const Scene &scene, const SourceView &view, const Regulus &regulus, const Triple &edges)
        : view_(view), receiver_(scene.surface(view.receiver)), regulus_(regulus), edges_(edges) {}

    void run(IntervalSet domain, std::vector<Curve> &curves) {
        open_ = std::move(domain);
        keep_lit();
        keep_source();
        for (const SightEdge *edge : edges_)
            for (const std::size_t f : edge->facets)
                if (!open_.empty())
                    meet(view_.facets[f]);
        for (std::size_t f = 0; f < view_.facets.size() && !open_.empty(); ++f)
            meet(view_.facets[f]);
        std::ranges::sort(grazed_);
        const auto twins = std::ranges::unique(grazed_);
        grazed_.erase(twins.begin(), twins.end());
        for (const Interval &piece : open_.intervals())
            if (Vec2(regulus_.foot(piece.high) - regulus_.foot(piece.low)).norm() >= shortest_curve)
                judge(piece, curves);
    }

private:
    template <class Test>
    void keep(std::vector<double> &ends, const Test &test) {
        for (const double s : ends)
            open_.split(s);
        IntervalSet kept;
        for (const Interval &i : open_.intervals())
            if (test(i.middle()))
                kept.unite(i);
        open_ = std::move(kept);
    }
    Interval hull() const { return {open_.intervals().front().low, open_.intervals().back().high}; }

    void add_sides(std::span<const Vec3> polygon, std::vector<double> &ends) const {
        for (std::size_t i = 0; i < polygon.size(); ++i)
            regulus_.side(polygon[i], polygon[(i + 1) % polygon.size()]).add_roots(hull(), ends);
    }

    /// The feet on the receiver, off its covers and in front of the source.
    void keep_lit() {
        if (open_.empty())
            return;
        std::vector<double> ends;
        add_sides(receiver_.corners, ends);
        for (const Polygon &cover : receiver_.covers) {
            std::vector<Vec3> corners;
            for (const Vec2 &p : cover)
                corners.push_back(receiver_.frame.to_space(p));
            add_sides(corners, ends);
        }
        regulus_.rise().add_roots(hull(), ends);
        regulus_.foot_height(view_.source_plane).add_roots(hull(), ends);
        keep(ends, [&](double s) {
            const Vec2 foot = regulus_.foot(s);
            return foot.allFinite() && view_.source_plane.height(receiver_.frame.to_space(foot)) > coincidence &&
                   std::ranges::any_of(receiver_.parts, [&](const Polygon &p) { return contains(p, foot); }) &&
                   !is_covered(receiver_, foot);
        });
    }

    /// Lines that reach the source.
    void keep_source() {
        if (open_.empty())
            return;
        std::vector<double> ends;
        for (const Facet &part : view_.source_parts)
            add_sides(part.corners, ends);
        keep(ends, [&](double s) {
            LocalPicture picture(regulus_.line(s), view_.receiver_plane.u);
            return std::ranges::any_of(view_.source_parts, [&](const Facet &part) {
                return picture.add_source(part) != Meeting::apart;
            });
        });
    }

    void meet(const Facet &facet) {
        // No corner's side changes over all that is open, and the sides differ: the common case of a facet far away.
        std::vector<double> ends;
        add_sides(facet.corners, ends);
        bool any = false;
        keep(ends, [&](double s) {
            LocalPicture picture(regulus_.line(s), view_.receiver_plane.u);
            const Meeting meeting = picture.add_blocker(facet);
            any |= meeting == Meeting::grazed;
            return meeting != Meeting::pierced;
        });
        if (any)
            grazed_.push_back(&facet);
    }

    void judge(const Interval &piece, std::vector<Curve> &curves) const {
        const double s = piece.middle(), h = piece.length() / 64;
        const Vec2 along = (regulus_.foot(s + h) - regulus_.foot(s - h)).normalized();
        const PlaneFrame &plane = view_.receiver_plane;
        LocalPicture picture(regulus_.line(s), -along.y() * plane.u + along.x() * plane.v);
        for (const Facet &part : view_.source_parts)
            picture.add_source(part);
        for (const Facet *facet : grazed_)
            picture.add_blocker(*facet);
        if (!picture.changes())
            return;
        Curve curve{CurveKind::eee, 2, view_.source, view_.receiver, picture.bounding(), Vec2::Zero(), Vec2::Zero(),
                    Vec3::Zero(), {}};
        for (const SightEdge *edge : edges_)
            curve.touched.push_back({edge->from(), edge->to()});
        regulus_.set_arc(curve, piece);
        curves.push_back(std::move(curve));
    }

    const SourceView &view_;
    const Surface &receiver_;
    const Regulus &regulus_;
    Triple edges_;
    IntervalSet open_;
    std::vector<const Facet *> grazed_;
};

void trace(const Scene &scene, const SourceView &view, const Triple &edges, std::vector<Curve> &curves) {
    const auto regulus = Regulus::make(edges, view.receiver_plane);
    if (!regulus)
        return;
    if (IntervalSet domain = regulus->domain(); !domain.empty())
        TripleTracer(scene, view, *regulus, edges).run(std::move(domain), curves);
}

} // namespace

void trace_triples(const Scene &scene, const SourceView &view, std::vector<Curve> &curves) {
    const std::vector<SightEdge> &edges = view.blocker_edges;
    for (std::size_t i = 0; i < edges.size(); ++i)
        for (std::size_t j = i + 1; j < edges.size(); ++j) {
            for (const SightEdge &source_edge : view.source_edges)
                trace(scene, view, {&source_edge, &edges[i], &edges[j]}, curves);
            for (std::size_t k = j + 1; k < edges.size(); ++k)
                trace(scene, view, {&edges[i], &edges[j], &edges[k]}, curves);
        }
}

} // namespace penumbra
