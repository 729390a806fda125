#include "discontinuity/trace_contacts.h"

#include "discontinuity/receiver_line.h"
#include "discontinuity/sees_source.h"

#include <algorithm>
#include <cmath>

namespace penumbra {

namespace {

/// How far beside a contact its sides are probed for covers [solver units].
constexpr double beside = 1e-7;

struct Contact {
    Vec2 from, to;
    std::vector<SurfaceId> blockers; ///< none for a cover's border
};

std::vector<Contact> contacts_of(const Scene &scene, const SourceView &view) {
    std::vector<Contact> contacts;
    for (const Facet &facet : view.facets) {
        Vec3 p = Vec3::Zero(), q = Vec3::Zero();
        int n = 0;
        for (const Vec3 &c : facet.corners)
            if (std::abs(view.receiver_plane.height(c)) <= coincidence) {
                (n == 0 ? p : q) = c;
                ++n;
            }
        if (n >= 2)
            contacts.push_back({view.receiver_plane.to_plane(p), view.receiver_plane.to_plane(q), {facet.surface}});
    }
    for (const Polygon &cover : scene.surface(view.receiver).covers)
        for (std::size_t i = 0; i < cover.size(); ++i)
            contacts.push_back({cover[i], cover[(i + 1) % cover.size()], {}});
    return contacts;
}

bool covered(const Surface &receiver, const Vec2 &p) {
    return std::ranges::any_of(receiver.covers, [&](const Polygon &cover) { return contains(cover, p); });
}

/// Whether the side of the contact at x towards which `across` points sees any of the source.
bool side_sees(const Scene &scene, const SourceView &view, const SightCells &cells, const Vec2 &x,
               const Vec2 &across) {
    const Surface &receiver = scene.surface(view.receiver);
    if (covered(receiver, x + beside * across))
        return false;
    const SightCell *cell = cells.at(x + beside * across);
    if (!cell)
        return false;
    const Vec3 point = receiver.frame.to_space(x),
               outward = across.x() * receiver.frame.u + across.y() * receiver.frame.v;
    std::vector<std::size_t> touching;
    std::vector<Vec3> half_spaces;
    for (const std::size_t f : cell->facets) {
        const Facet &facet = view.facets[f];
        if (!touches(facet, point))
            continue;
        touching.push_back(f);
        half_spaces.push_back(facet.frame.normal.dot(outward) > 0 ? facet.frame.normal : Vec3(-facet.frame.normal));
    }
    return sees_source(view, point, half_spaces, cell->facets, touching);
}

/// Parameters along the unit direction where the line meets the curves, and a little beyond their ends.
void split_at_curves(IntervalSet &line, const Vec2 &foot, const Vec2 &along, std::span<const Curve> curves) {
    for (const Curve &curve : curves) {
        const Vec2 other = curve.to - curve.from;
        const double turn = cross(along, other), length = other.norm();
        if (std::abs(turn) <= coincidence * length)
            continue;
        const double t = cross(curve.from - foot, along) / turn; // along the other, 0 to 1
        if (t * length > -beside && (t - 1) * length < beside)
            line.split(cross(curve.from - foot, other) / turn);
    }
}

} // namespace

void trace_contacts(const Scene &scene, const SourceView &view, const SightCells &cells, std::vector<Curve> &curves) {
    const std::vector<Contact> contacts = contacts_of(scene, view);
    std::vector<Curve> others;
    for (const Curve &curve : curves)
        if (curve.source == view.source && curve.receiver == view.receiver)
            others.push_back(curve);
    for (const Contact &contact : contacts)
        others.push_back({CurveKind::contact, 0, view.source, view.receiver, {}, contact.from, contact.to});
    for (const Contact &contact : contacts) {
        cells.check_cancel();
        const double length = (contact.to - contact.from).norm();
        if (length < shortest_curve)
            continue;
        const Vec2 along = (contact.to - contact.from) / length, across(-along.y(), along.x());
        const Vec3 along_in_space = along.x() * view.receiver_plane.u + along.y() * view.receiver_plane.v;
        IntervalSet line = lit_part(scene, view, view.receiver_plane.to_space(contact.from), along_in_space);
        line.clip(Interval{0, length});
        split_at_curves(line, contact.from, along, others);
        IntervalSet kept;
        for (const Interval &piece : line.intervals()) {
            const Vec2 x = contact.from + piece.middle() * along;
            if (side_sees(scene, view, cells, x, across) || side_sees(scene, view, cells, x, -across))
                kept.unite(piece);
        }
        kept.drop_shorter(shortest_curve);
        for (const Interval &i : kept.intervals())
            curves.push_back({CurveKind::contact, 0, view.source, view.receiver, contact.blockers,
                              contact.from + i.low * along, contact.from + i.high * along});
    }
}

} // namespace penumbra
