// The convex hull of a receiver and a source, and what can be in it.
#pragma once

#include "core/vec.h"
#include "geometry/plane_frame.h"

#include <span>
#include <utility>
#include <vector>

namespace penumbra {

/// The convex hull of two convex polygons, as half-spaces: the planes that contain an edge of the one and a corner of
/// the other and have both polygons on one side, and the two polygons' own planes (nothing behind either blocks).
class Shaft {
public:
    /// Each polygon with the frame of its plane, front towards the other.
    Shaft(std::span<const Vec3> receiver, const PlaneFrame &receiver_frame, std::span<const Vec3> source,
          const PlaneFrame &source_frame);

    /// True only if the polygon keeps out of the shaft's interior by a separating face plane (it may touch the shaft, to
    /// within 1e-12): then it blocks nothing. With a `gap`, only if the plane keeps this distance. Conservative: false
    /// proves nothing.
    bool misses(std::span<const Vec3> polygon, double gap = -1e-12) const;
    /// The part of the segment p + t (q - p), 0 <= t <= 1, that no face plane leaves more than `slack` outside; low above
    /// high when there is none.
    std::pair<double, double> part_inside(const Vec3 &p, const Vec3 &q, double slack) const;
    /// Smallest box around both polygons.
    const Vec3 &low() const { return low_; }
    const Vec3 &high() const { return high_; }

private:
    struct Plane {
        Vec3 normal; ///< unit, outwards
        double offset;
    };
    std::vector<Plane> planes_;
    Vec3 low_, high_;
};

/// True only if the convex polygon `blocker` (corners in its plane `frame`) crosses every segment between the two convex
/// polygons: then neither sees anything of the other.
bool spans_shaft(std::span<const Vec3> blocker, const PlaneFrame &frame, std::span<const Vec3> receiver,
                 std::span<const Vec3> source);

} // namespace penumbra
