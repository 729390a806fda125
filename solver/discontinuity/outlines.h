// Corners and edges of several polygons, those that coincide taken once.
#pragma once

#include "core/vec.h"
#include "geometry/plane_frame.h"

#include <map>
#include <set>
#include <span>
#include <utility>
#include <vector>

namespace penumbra {

struct OutlineEdge {
    Vec3 a, b;
};

/// Neighbouring faces agree on a corner only to within rounding, and mended ones to within `weld`: here they share it.
class Outlines {
public:
    /// Corners within twice the `tolerance` of one another become one, the first; those within it of a plane are moved
    /// into the plane.
    Outlines(double tolerance, std::vector<PlaneFrame> planes) : tolerance_(tolerance), planes_(std::move(planes)) {}

    /// Returns the outline's corners as they are after welding.
    std::vector<Vec3> add(std::span<const Vec3> outline);
    void add_corner(const Vec3 &corner) { id_of(corner); }
    void add_edge(const Vec3 &a, const Vec3 &b);
    /// Adds a corner wherever two edges cross or touch between their ends, to within `reach`.
    void add_crossings(double reach);

    const std::vector<Vec3> &corners() const { return corners_; }
    /// Each once, by the order in which its corners were added.
    std::vector<OutlineEdge> edges() const;

private:
    std::size_t id_of(const Vec3 &corner);
    void join(std::size_t i, std::size_t j);

    double tolerance_;
    std::vector<PlaneFrame> planes_;
    std::vector<Vec3> corners_;
    std::multimap<double, std::size_t> ids_; ///< by the corner's height over a skew plane
    std::set<std::pair<std::size_t, std::size_t>> edges_;
};

} // namespace penumbra
