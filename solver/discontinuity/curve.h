// A discontinuity curve on a receiver: where the irradiance from one source, or one of its derivatives, jumps.
#pragma once

#include "core/ids.h"
#include "core/vec.h"

#include <string_view>
#include <vector>

namespace penumbra {

/// What kind of critical surface throws it (Heckbert 1992; Lischinski, Tampieri & Greenberg 1992; Drettakis & Fiume
/// 1994): a vertex on the source's side and an edge on the blocker's, the reverse, three skew edges, the plane of a
/// source or of a blocker seen edge-on, or a blocker that touches or pierces the receiver.
enum class CurveKind { ve, ev, eee, plane, contact };

/// `VE`, `EV`, `EEE`, `plane`, `contact`.
std::string_view name(CurveKind kind);

struct Curve {
    CurveKind kind = CurveKind::ve;
    int order = 2; ///< the first derivative that jumps: 0 the irradiance itself, 1 its slope, 2 its curvature
    SurfaceId source;
    SurfaceId receiver;
    std::vector<SurfaceId> blockers; ///< ascending
    Vec2 from, to;                   ///< end points in the receiver's plane, solver units
};

} // namespace penumbra
