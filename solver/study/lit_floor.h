// A receiver and a black emitter that it sees whole: the closed form is Lambert's.
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

} // namespace penumbra
