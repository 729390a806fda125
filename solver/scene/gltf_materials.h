// Materials of a glTF file.
#pragma once

#include "scene/json_value.h"
#include "scene/scene.h"
#include "scene/skipped.h"

namespace penumbra {

struct GltfMaterials {
    std::vector<Material> materials; ///< by glTF's index, then grey 0.5 for primitives without one
    std::vector<bool> double_sided;
    std::vector<bool> is_grey; ///< the file gives no colour: grey 0.5 is taken
};

/// Reflectance: pbrMetallicRoughness.baseColorFactor; where it is absent 0 for an emitter, else grey 0.5 (white, glTF's
/// default, cannot be solved). Exitance [W/m2]: emissiveFactor times KHR_materials_emissive_strength. Textures are
/// counted as skipped. Whether the values make sense is checked by build_scene.
GltfMaterials read_gltf_materials(const JsonValue &root, Skipped &skipped);

} // namespace penumbra
