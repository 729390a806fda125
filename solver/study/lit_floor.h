// A receiver and a black emitter that it sees whole: the closed form is Lambert's.
#pragma once

#include "study/trial.h"

namespace penumbra {

/// The largest error on the receiver's points against rho E times Lambert's form factor, as a fraction of the largest
/// value there, may be the threshold; and soundness(). The receiver is faces[0], the emitter is faces[1]; whatever else
/// there is may take no light away at the points.
std::vector<Measurement> compare_with_lambert(const Faces &faces, const std::vector<Vec3> &points,
                                              const TrialSetting &setting);

} // namespace penumbra
