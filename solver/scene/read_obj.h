// Wavefront OBJ and MTL. Real files are messy: any line ends, a byte order mark, continued lines, relative indices, a
// `usemtl` before its `mtllib`, names with blanks and materials without `Ke` are read as meant.
#pragma once

#include "scene/scene.h"

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace penumbra {

inline constexpr std::size_t largest_obj = std::size_t{256} << 20; ///< bytes; longer files are refused
inline constexpr std::size_t largest_mtl = std::size_t{16} << 20;
inline constexpr std::size_t most_vertices = 8'000'000, most_libraries = 16;

/// Reads `file`; polygons are kept whole. Kd is the reflectance, Ke the emitted exitance [W/m2]; a missing MTL or a
/// face without material is grey 0.5 and noted. Throws BadInput, one line. See CONTRACT "Scenes" in the README.
/// A material library is looked for beside the file and below; names that lead elsewhere are treated as missing.
Scene read_obj(const std::filesystem::path &file, const Vec3 &up = Vec3::UnitZ());

/// Text of the material library of that name, or nothing when there is none.
using OpenLibrary = std::function<std::optional<std::string>(const std::string &name)>;

/// The same from memory; `file` is what messages call it.
Scene read_obj_text(const std::filesystem::path &file, std::string_view text, const OpenLibrary &open,
                    const Vec3 &up = Vec3::UnitZ());

} // namespace penumbra
