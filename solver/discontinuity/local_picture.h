// What is seen close about one line of sight from the two sides of a curve: whether a critical event is real.
#pragma once

#include "discontinuity/sight_line.h"
#include "discontinuity/source_view.h"

#include <array>
#include <span>
#include <utility>
#include <vector>

namespace penumbra {

/// How a facet meets a line of sight.
enum class Meeting { apart, grazed, pierced };

/// The picture about a line of sight, magnified without limit, as an eye sees it that stands an infinitely small step
/// beside the line's foot. A facet's edge that the line touches is a straight line there, displaced against the step by
/// the inverse of its distance from the eye; a corner is where two of them meet, a facet seen edge-on opens to a strip.
/// Whatever the line passes through without touching its border fills the picture or is not in it. An event is real if
/// the visible part of the source has other corners in the picture of the one side than in that of the other.
class LocalPicture {
public:
    /// `step`: unit vector in the receiver's plane, across the curve.
    LocalPicture(const SightLine &line, const Vec3 &step);

    Meeting add_source(const Facet &facet) { return add(facet, true); }
    Meeting add_blocker(const Facet &facet) { return add(facet, false); }

    /// Whether the shape of the visible part changes. False when a blocker was pierced or no source met.
    bool changes();
    /// Whether what is seen changes its area with a kink, that is, over a length that does not vanish: edges in one
    /// plane with the eye, whose trace in the picture runs along `trace` (in space). The order of the event is then 1.
    bool kinks(const Vec3 &trace) const;
    /// The same along lines in one plane with the eye whose traces in the picture run along `trace` (in space) without
    /// an end: whether other ones bound the visible part, a strip between two closes. The order of the event is 1.
    bool strips_change(const Vec3 &trace);
    /// Surfaces of the blockers that bound the visible part about the line on either side, ascending; after changes() or
    /// strips_change().
    std::vector<SurfaceId> bounding() const;

private:
    struct Line {
        Vec2 along;
        double nearness; ///< inverse distance from the eye
    };
    struct Border {
        std::size_t line;
        double inside; ///< +1 on the line's left, -1 on its right
    };
    struct Figure {
        SurfaceId surface;
        bool source, strip = false; ///< a strip lies between its two borders whichever is the nearer side
        int n_borders = 0;
        std::array<Border, 4> borders{};
    };
    using Shape = std::vector<std::pair<std::size_t, std::size_t>>; ///< lines that cross in a visible corner

    Meeting add(const Facet &facet, bool source);
    Meeting meet(const Facet &facet, Figure &figure);
    Meeting meet_edge_on(const Facet &facet, Figure &figure);
    void add_border(Figure &figure, double nearness, const Vec2 &along, double inside);
    Vec2 place(const Line &line, double side) const { return side * line.nearness / nearest_ * displacement_; }
    /// Whether the source is seen where lines lie on the given sides: depth(line) is positive on a line's left.
    template <class Depth> bool sees(double side, const Depth &depth) const;
    bool sees_beside(const Vec2 &at, const Vec2 &towards, double side) const;
    bool is_corner(const Vec2 &at, double side) const;
    Shape shape(double side) const;
    /// Far away along `towards` the picture is one of strips: calls visit(width, seen, line at its far border).
    template <class Visit> void for_each_strip(const Vec2 &towards, double side, const Visit &visit) const;
    double seen_far_away(const Vec2 &towards, double side) const;
    Vec2 in_picture(const Vec3 &direction) const { return Vec2(direction.dot(u_), direction.dot(v_)).normalized(); }

    SightLine eye_;
    Vec3 u_, v_; ///< with eye_.along a right-handed frame
    Vec2 displacement_; ///< unit
    double nearest_ = 0;
    bool hidden_ = false, any_source_ = false;
    std::vector<Line> lines_;
    std::vector<Figure> figures_;
    std::vector<char> bounding_; ///< by line
};

} // namespace penumbra
