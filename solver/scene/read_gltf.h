// glTF 2.0, as text (.gltf) or in one binary file (.glb). The JSON is parsed by a library; what stands in it is walked
// here and checked value by value, so that a message can name it: loaders of whole files take wrong types, ranges and
// cycles without a word.
#pragma once

#include "scene/open_buffer.h"
#include "scene/scene.h"

#include <cstddef>
#include <filesystem>
#include <string_view>

namespace penumbra {

inline constexpr std::size_t largest_gltf = std::size_t{256} << 20; ///< bytes; longer files are refused

/// Reads `file`. Base colour is the reflectance, emissive factor times KHR_materials_emissive_strength the exitance
/// [W/m2]; meshes stand where the nodes of the default scene put them; coplanar triangles of a mesh that share edges
/// and a material are one face; the first perspective camera is the scene's view. Textures, animations, skins and
/// lights are counted and said once. Throws BadInput, one line; see CONTRACT "Scenes" in the README. Buffers are looked
/// for beside the file and below.
Scene read_gltf(const std::filesystem::path &file, const Vec3 &up = Vec3::UnitY());

/// The same from memory; `file` is what messages call it.
Scene read_gltf_bytes(const std::filesystem::path &file, std::string_view bytes, const OpenBuffer &open,
                      const Vec3 &up = Vec3::UnitY());

} // namespace penumbra
