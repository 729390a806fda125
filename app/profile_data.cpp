#include "profile_data.h"

#include "render/curve_crossing.h"

namespace penumbra {

ProfileData profile_frame(const Snapshot &snapshot, const ProfileLine &line) {
    ProfileData data;
    const SnapshotSurface &surface = snapshot.surfaces[static_cast<std::size_t>(line.surface)];
    data.scene = snapshot.scene;
    data.surface = surface.name.empty() ? "surface " + std::to_string(line.surface) : surface.name;
    data.length = line.length();
    for (const CurveCrossing &crossing : crossed_curves(snapshot, line.surface, line.from, line.to)) {
        const SnapshotCurve &curve = (*snapshot.curves)[static_cast<std::size_t>(crossing.curve)];
        data.crossings.push_back({crossing.part * data.length, curve.kind, curve.order});
    }
    return data;
}

ProfileCurve profile_curve(const Snapshot &snapshot, const ProfileLine &line) {
    return {snapshot.options.strategy, snapshot.options.effective_order(), profile(snapshot, line, n_profile_points),
            snapshot.reconstructed};
}

std::vector<double> break_places(const ProfileData &data) {
    std::vector<double> places;
    for (const ProfileCrossing &c : data.crossings)
        places.push_back(c.at);
    return places;
}

} // namespace penumbra
