#include "render/curve_filter.h"

namespace penumbra {

bool CurveFilter::shows(const SnapshotCurve &curve) const {
    return kinds.at(static_cast<std::size_t>(curve.kind)) && orders.at(static_cast<std::size_t>(curve.order)) &&
           (source < 0 || source == curve.source);
}

} // namespace penumbra
