// A receiver in cells small enough that little of what lies between it and a source can be seen one behind the other.
#pragma once

#include "core/cancel.h"
#include "discontinuity/source_view.h"
#include "scene/scene.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace penumbra {

/// A convex part of the receiver from where something of the source may be seen.
struct SightCell {
    Polygon outline;                 ///< in the receiver's plane
    std::vector<std::size_t> facets; ///< of the view, ascending: those that reach into the shaft from here to the source
};

/// What one line of sight may touch: a corner and an edge, two edges in one plane, three edges, or a facet's plane; by
/// their places in the view's lists.
struct Encounter {
    std::array<std::size_t, 3> touched{}; ///< as many as the kind has
    std::vector<std::size_t> cells;       ///< ascending; from elsewhere no line of sight touches all of them
};

/// Events on a receiver come from things that overlap as seen from one of its points, before the source. All triples of
/// edges are too many to try. The receiver is halved until hardly anything overlaps as seen from a cell; cells from
/// which one facet hides all of the source are left out. What a cell's lines of sight may pass is found with the
/// shaft to the source (Haines & Wallace 1991), and what may overlap by the places in the source's plane where a thing
/// can be seen from anywhere in the cell. Both are conservative: an encounter left out has no line of sight.
class SightCells {
public:
    /// Looks at the flag as it divides, and with every walk through its encounters.
    SightCells(const Scene &scene, const SourceView &view, const Cancel *cancel = nullptr);

    const SightCell &operator[](std::size_t i) const { return cells_[i]; }
    std::span<const Encounter> corners_and_edges() const { return corners_and_edges_; }
    std::span<const Encounter> edges_in_plane() const { return edges_in_plane_; }
    std::span<const Encounter> triples() const { return triples_; }
    std::span<const Encounter> planes() const { return planes_; } ///< of facets

    void check_cancel() const {
        if (cancel_)
            cancel_->check();
    }
    /// Facets that reach into the shaft from any of the encounter's cells, ascending.
    std::vector<std::size_t> facets(const Encounter &encounter) const;
    /// The cell that holds the point; none where the source is hidden or the point lies outside.
    const SightCell *at(const Vec2 &p) const;
    /// The parts of a line of the receiver's plane, given in space, in the encounter's cells.
    IntervalSet line_inside(const Encounter &encounter, const Vec3 &foot, const Vec3 &along) const;
    bool contains(const Encounter &encounter, const Vec2 &p) const;

private:
    struct Key {
        std::array<std::uint32_t, 3> touched;
        std::uint32_t cell;
        auto operator<=>(const Key &) const = default;
    };
    friend class CellDivision;
    static std::vector<Encounter> gathered(std::vector<Key> keys);

    PlaneFrame plane_;
    const Cancel *cancel_;
    std::vector<SightCell> cells_;
    std::vector<Encounter> corners_and_edges_, edges_in_plane_, triples_, planes_;
};

} // namespace penumbra
