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
    TripleTracer(const Scene &scene, const SourceView &view, const SightCells &cells, const Encounter &encounter,
                 const Regulus &regulus, const Triple &edges)
        : view_(view), cells_(cells), encounter_(encounter), receiver_(scene.surface(view.receiver)),
          regulus_(regulus), edges_(edges) {}

    void run(IntervalSet domain, std::vector<Curve> &curves) {
        open_ = std::move(domain);
        keep_lit();
        keep_source();
        for (const SightEdge *edge : edges_)
            for (const std::size_t f : edge->facets)
                if (!open_.empty())
                    meet(view_.facets[f]);
        if (open_.empty())
            return;
        for (const std::size_t f : cells_.facets(encounter_))
            if (!open_.empty())
                meet(view_.facets[f]);
        keep_in_cells();
        std::ranges::sort(grazed_);
        const auto twins = std::ranges::unique(grazed_);
        grazed_.erase(twins.begin(), twins.end());
        emit(curves);
    }

private:
    /// Keeps the pieces between the given ends at whose middle the test holds, each for itself.
    template <class Test>
    void keep(const std::vector<double> &ends, const Test &test) {
        for (const double s : ends)
            open_.split(s);
        const IntervalSet pieces = open_;
        for (const Interval &i : pieces.intervals())
            if (!test(i.middle()))
                open_.subtract(i);
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

    /// What lies elsewhere was not held against all that blocks there.
    void keep_in_cells() {
        if (open_.empty())
            return;
        std::vector<double> ends;
        for (const std::size_t cell : encounter_.cells) {
            std::vector<Vec3> corners;
            for (const Vec2 &p : cells_[cell].outline)
                corners.push_back(receiver_.frame.to_space(p));
            add_sides(corners, ends);
        }
        keep(ends, [&](double s) { return cells_.contains(encounter_, regulus_.foot(s)); });
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

    /// Takes out the lines that cross the facet; where some graze it, cuts between those that do and those that do not.
    void meet(const Facet &facet) {
        std::vector<double> ends;
        add_sides(facet.corners, ends);
        IntervalSet pieces = open_;
        for (const double s : ends)
            pieces.split(s);
        bool grazes = false;
        for (const Interval &i : pieces.intervals()) {
            LocalPicture picture(regulus_.line(i.middle()), view_.receiver_plane.u);
            const Meeting meeting = picture.add_blocker(facet);
            if (meeting == Meeting::pierced)
                open_.subtract(i);
            grazes |= meeting == Meeting::grazed;
        }
        if (!grazes)
            return;
        grazed_.push_back(&facet);
        for (const double s : ends)
            open_.split(s);
    }

    bool short_on_receiver(const Interval &i) const {
        return Vec2(regulus_.foot(i.high) - regulus_.foot(i.low)).norm() < shortest_curve;
    }

    /// Neighbouring pieces that are real with the same blockers make one arc.
    void emit(std::vector<Curve> &curves) const {
        std::optional<std::vector<SurfaceId>> growing;
        Interval arc;
        const auto finish = [&] {
            if (growing && !short_on_receiver(arc))
                curves.push_back(curve(arc, *growing));
        };
        for (const Interval &i : open_.intervals()) {
            if (short_on_receiver(i))
                continue;
            auto blockers = real_blockers(i);
            if (growing && blockers == growing && (i.low <= arc.high || short_on_receiver({arc.high, i.low}))) {
                arc.high = i.high;
                continue;
            }
            finish();
            growing = std::move(blockers);
            arc = i;
        }
        finish();
    }

    /// What bounds the visible part beside the arc, if the arc is real.
    std::optional<std::vector<SurfaceId>> real_blockers(const Interval &piece) const {
        const double s = piece.middle(), h = piece.length() / 64;
        const Vec2 along = (regulus_.foot(s + h) - regulus_.foot(s - h)).normalized();
        const PlaneFrame &plane = view_.receiver_plane;
        LocalPicture picture(regulus_.line(s), -along.y() * plane.u + along.x() * plane.v);
        for (const Facet &part : view_.source_parts)
            picture.add_source(part);
        for (const Facet *facet : grazed_)
            picture.add_blocker(*facet);
        return picture.changes() ? std::optional(picture.bounding()) : std::nullopt;
    }

    static bool is_flat(const Curve &arc) {
        const Vec2 along = (arc.to - arc.from).normalized();
        return std::ranges::all_of(std::array{0.25, 0.5, 0.75}, [&](double t) {
            return std::abs(cross(along, point_at(arc, t) - arc.from)) <= coincidence;
        });
    }

    Curve curve(const Interval &arc, const std::vector<SurfaceId> &blockers) const {
        Curve curve{CurveKind::eee, 2, view_.source, view_.receiver, blockers, Vec2::Zero(), Vec2::Zero(),
                    Vec3::Zero(), {}};
        for (const SightEdge *edge : edges_)
            curve.touched.push_back({edge->from(), edge->to()});
        regulus_.set_arc(curve, arc);
        if (is_flat(curve)) // then it may lie in line with others
            curve.control.setZero();
        return curve;
    }

    const SourceView &view_;
    const SightCells &cells_;
    const Encounter &encounter_;
    const Surface &receiver_;
    const Regulus &regulus_;
    Triple edges_;
    IntervalSet open_;
    std::vector<const Facet *> grazed_;
};

} // namespace

void trace_triples(const Scene &scene, const SourceView &view, const SightCells &cells, std::vector<Curve> &curves) {
    for (const Encounter &encounter : cells.triples()) {
        cells.check_cancel();
        const Triple edges{&view.edges[encounter.touched[0]], &view.edges[encounter.touched[1]],
                           &view.edges[encounter.touched[2]]};
        const auto regulus = Regulus::make(edges, view.receiver_plane);
        if (!regulus)
            continue;
        if (IntervalSet domain = regulus->domain(); !domain.empty())
            TripleTracer(scene, view, cells, encounter, *regulus, edges).run(std::move(domain), curves);
    }
}

} // namespace penumbra
