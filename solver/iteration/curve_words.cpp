#include "iteration/curve_words.h"

#include "discontinuity/curve.h"

#include <algorithm>

namespace penumbra {

std::string listed(const std::vector<std::string> &names) {
    std::vector<std::string> once;
    for (const std::string &name : names)
        if (std::ranges::find(once, name) == once.end())
            once.push_back(name);
    std::string text;
    for (std::size_t i = 0; i < once.size(); ++i)
        text += (i == 0 ? "" : i + 1 < once.size() ? ", " : " and ") + once[i];
    return text;
}

const SnapshotEdge *touched(const SnapshotCurve &curve, bool corner) {
    for (const SnapshotEdge &edge : curve.touched)
        if (edge.is_corner() == corner)
            return &edge;
    return nullptr;
}

std::string curve_words(const SnapshotCurve &curve, const std::function<std::string(int)> &name) {
    const auto kind = static_cast<CurveKind>(curve.kind);
    const std::string what = std::string(penumbra::name(kind)) + " curve of ";
    const auto owner = [&](const SnapshotEdge &edge) { return edge.surface < 0 ? "a blocker" : name(edge.surface); };
    const SnapshotEdge *corner = touched(curve, true), *edge = touched(curve, false);
    if (kind == CurveKind::ve && corner && edge)
        return what + "a corner of " + owner(*corner) + " and an edge of " + owner(*edge);
    if (kind == CurveKind::ev && corner && edge)
        return what + "an edge of " + owner(*edge) + " and a corner of " + owner(*corner);
    std::vector<std::string> owners;
    for (const SnapshotEdge &e : curve.touched)
        owners.push_back(owner(e));
    if (!owners.empty())
        return what + "edges of " + listed(owners);
    owners.push_back(name(curve.source));
    for (const std::int32_t blocker : curve.blockers)
        owners.push_back(name(blocker));
    return what + listed(owners);
}

} // namespace penumbra
