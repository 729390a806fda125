// Scenes written down in a test.
#pragma once

#include "scene/read_obj.h"

namespace penumbra {

/// Reads `obj` as the file t.obj, with `mtl` as any material library that it names.
inline Scene scene_of(const std::string &obj, const std::string &mtl = "", const Vec3 &up = Vec3::UnitZ()) {
    return read_obj_text(
        "t.obj", obj, [&](const std::string &) { return mtl.empty() ? std::nullopt : std::optional(mtl); }, up);
}

} // namespace penumbra
