// What a profile's plot is made of, from snapshots.
#pragma once

#include "iteration/snapshot.h"
#include "plot/profile_sheet.h"

#include <vector>

namespace penumbra {

/// Names, length and crossings; no values yet. `snapshot` holds all curves, those of reflectors, too.
ProfileData profile_frame(const Snapshot &snapshot, const ProfileLine &line);
ProfileCurve profile_curve(const Snapshot &snapshot, const ProfileLine &line);
/// Where the truth is asked for on either side.
std::vector<double> break_places(const ProfileData &data);

} // namespace penumbra
