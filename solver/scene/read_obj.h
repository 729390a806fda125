// Wavefront OBJ and MTL.
#pragma once

#include "scene/scene.h"

namespace penumbra {

/// Reads `file`; polygons are kept whole. Kd is the reflectance, Ke the emitted exitance [W/m2]; a missing MTL or a
/// face without material is grey 0.5 and noted. Throws BadInput, one line. See CONTRACT "Scenes" in the README.
Scene read_obj(const std::filesystem::path &file, const Vec3 &up = Vec3::UnitZ());

} // namespace penumbra
