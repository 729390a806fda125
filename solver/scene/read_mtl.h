// Wavefront material libraries.
#pragma once

#include "scene/scene.h"
#include "scene/skipped.h"

#include <string>
#include <string_view>
#include <vector>

namespace penumbra {

/// Appends the materials of `text`. Kd: reflectance (0 for an emitter without it, else grey 0.5, noted); Ke: exitance
/// [W/m2], 0 without it. A single number serves all channels. Whether the values make sense is checked by build_scene.
/// Throws BadInput where a number cannot be read, and beyond the limits of validate.h; `file` is what messages call it.
void read_mtl(const std::string &file, std::string_view text, std::vector<Material> &materials, Skipped &skipped,
              std::vector<std::string> &notes);

} // namespace penumbra
