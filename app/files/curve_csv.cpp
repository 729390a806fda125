#include "files/curve_csv.h"

#include "discontinuity/curve.h"

#include <fmt/format.h>
#include <iterator>

namespace penumbra {

std::string curve_csv(const std::vector<SnapshotCurve> &curves) {
    std::string csv = "curve,kind,order,source,receiver,x,y,z,blockers\n";
    for (std::size_t i = 0; i < curves.size(); ++i) {
        const SnapshotCurve &c = curves[i];
        std::string blockers;
        for (const std::int32_t b : c.blockers)
            blockers += (blockers.empty() ? "" : " ") + std::to_string(b);
        for (const Vec3 &x : c.points)
            fmt::format_to(std::back_inserter(csv), "{},{},{},{},{},{},{},{},{}\n", i,
                           name(static_cast<CurveKind>(c.kind)), c.order, c.source, c.receiver, x.x(), x.y(), x.z(),
                           blockers);
    }
    return csv;
}

} // namespace penumbra
