// The two forms of glTF 2.0: JSON text (.gltf), and JSON with one binary buffer behind it (.glb).
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace penumbra {

struct GltfContainer {
    std::string_view json;
    std::optional<std::string_view> binary; ///< of a .glb that has one
};

/// Which form it is the bytes say, not the file's name. Throws BadInput for a .glb of another version, or whose chunks
/// go beyond its bytes.
GltfContainer split_container(const std::string &file, std::string_view bytes);

/// Bytes of a base64 text (RFC 4648, padded or not); nothing where it is none.
std::optional<std::string> decode_base64(std::string_view text);

} // namespace penumbra
