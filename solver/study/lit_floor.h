// A receiver and a black emitter: what each point gets is known, by Lambert's closed form where all is seen, else by what is
// seen of the emitter.
#pragma once

#include "study/trial.h"

namespace penumbra {

/// The largest error on the receiver's points against rho E times Lambert's form factor, as a fraction of the largest
/// value there, may be the threshold; and soundness(). The receiver has the plane and the reflectance of faces[0]; all
/// that emits in `faces` makes up the lamp, and nothing takes light away at the points.
std::vector<Measurement> compare_with_lambert(const Faces &faces, const Face &lamp, const std::vector<Vec3> &points,
                                              const TrialSetting &setting);
/// The emitter is faces[1].
std::vector<Measurement> compare_with_lambert(const Faces &faces, const std::vector<Vec3> &points,
                                              const TrialSetting &setting);

/// The largest error on the points of faces[0] against the exact direct light (measure/direct.h) of the scene `as_seen`,
/// as a fraction of the largest value there, may be the threshold; and soundness(). `as_seen` has the same light: the
/// faces themselves, or fewer that shade alike. Light bounces once.
std::vector<Measurement> compare_with_direct(const Faces &faces, const Faces &as_seen, const std::vector<Vec3> &points,
                                             const TrialSetting &setting);

} // namespace penumbra
