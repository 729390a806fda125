// Which curves cross an element.
#pragma once

#include "core/ids.h"
#include "discontinuity/curve.h"
#include "geometry/polygon.h"

#include <span>
#include <vector>

namespace penumbra {

/// A curve's part inside a convex polygon of its receiver's plane; of an arc, a chord of it.
struct CurveSegment {
    CurveId curve;
    int order;
    Vec2 from, to;
};

/// The curves of each receiver; immutable, safe to ask from many threads.
class CurveIndex {
public:
    CurveIndex() = default;
    CurveIndex(std::vector<Curve> curves, int n_surfaces);

    const std::vector<Curve> &curves() const { return curves_; }
    const Curve &curve(CurveId c) const { return curves_[c.at()]; }
    std::span<const CurveId> on_receiver(SurfaceId receiver) const { return by_receiver_[receiver.at()]; }

    /// Curves of the given sources that pass through the interior of the convex polygon, in ascending order of their
    /// ids; one that runs along its border does not. Those of different sources that lie in one line come as one, under
    /// the id of the one with the lowest order, from the first end to the last. An arc comes as one chord of each part
    /// inside, or as several, of halves, where it is farther from its chord than an eighth of the polygon's radius or
    /// where the chord runs along the border: an element that was cut along a chord can be cut further, and what lies
    /// between cuts and arc falls to a quarter with every two cuts of a leaf (curve_index_test.cpp).
    std::vector<CurveSegment> crossing(SurfaceId receiver, const Polygon &convex,
                                       std::span<const SurfaceId> sources) const;

private:
    std::vector<Curve> curves_;
    std::vector<Eigen::AlignedBox2d> boxes_; ///< of the curves
    std::vector<std::vector<CurveId>> by_receiver_;
};

} // namespace penumbra
