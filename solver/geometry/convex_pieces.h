// A region of the plane as disjoint convex polygons, and cutting it by lines.
#pragma once

#include "geometry/polygon.h"

#include <span>
#include <vector>

namespace penumbra {

/// Points p with a p.x + b p.y + c >= 0. Not normalised: only the sign means something.
struct HalfPlane {
    double a = 0, b = 0, c = 0;
    double value(const Vec2 &p) const { return a * p.x() + b * p.y() + c; }
};

/// Convex polygons in one array, reused from call to call so that clipping allocates nothing in the long run.
class ConvexPieces {
public:
    std::size_t size() const { return first_.size() - 1; }
    bool empty() const { return size() == 0; }
    std::span<const Vec2> operator[](std::size_t i) const {
        return {points_.data() + first_[i], points_.data() + first_[i + 1]};
    }
    void clear() {
        points_.clear();
        first_.assign(1, 0);
    }
    void add(std::span<const Vec2> convex) {
        points_.insert(points_.end(), convex.begin(), convex.end());
        first_.push_back(points_.size());
    }
    double area() const;

private:
    std::vector<Vec2> points_;
    std::vector<std::size_t> first_{0};
};

/// Parts of a convex polygon on either side of a line; a part without area is left empty. No tolerance: a point is
/// inside when its value is >= 0.
void split(std::span<const Vec2> convex, const HalfPlane &h, Polygon &inside, Polygon &outside);

/// The part of every piece inside h.
void clip(const ConvexPieces &pieces, const HalfPlane &h, ConvexPieces &out);

/// What is left of every piece outside the convex region where all half-planes hold. Pieces that the region misses are
/// kept whole.
void subtract(const ConvexPieces &pieces, std::span<const HalfPlane> region, ConvexPieces &out);

/// Half-planes of a counter-clockwise convex polygon.
std::vector<HalfPlane> half_planes(std::span<const Vec2> convex);

} // namespace penumbra
