// Which discontinuity curves are shown.
#pragma once

#include "iteration/snapshot.h"

#include <array>

namespace penumbra {

struct CurveFilter {
    std::array<bool, 5> kinds{true, true, true, true, true}; ///< as CurveKind
    std::array<bool, 3> orders{true, true, true};
    int source = -1; ///< that surface's alone; -1: of all emitters

    bool shows(const SnapshotCurve &curve) const;
    bool operator==(const CurveFilter &) const = default;
};

} // namespace penumbra
