// Numbers of a glTF file: buffers, views of them, and accessors, with every extent checked before a byte is read.
#pragma once

#include "core/vec.h"
#include "scene/json_value.h"
#include "scene/open_buffer.h"

#include <map>

namespace penumbra {

/// All buffers that a scene uses may be this long together [bytes].
inline constexpr std::size_t largest_buffers = std::size_t{256} << 20;

/// Elements of one accessor; refers to the buffers' bytes.
struct GltfAccessor {
    std::string_view bytes; ///< from the first element on; long enough for all
    std::size_t count = 0, stride = 0;
    int component = 0; ///< glTF's number of the type: 5126 is float
    bool normalized = false;
    std::string path; ///< for messages: "accessors[4]"

    Vec3 vec3(std::size_t i) const;           ///< of a VEC3; i < count
    std::uint32_t index(std::size_t i) const; ///< of a SCALAR of unsigned whole numbers
};

/// Opens buffers when they are first used. Throws BadInput: an index, offset, length, stride or count that leads out of
/// its range, a URI that is missing, malformed or leaves the scene's folder, sparse or compressed accessors.
class GltfBuffers {
public:
    GltfBuffers(const JsonValue &root, std::optional<std::string_view> binary, OpenBuffer open)
        : root_(root), binary_(binary), open_(std::move(open)) {}

    GltfAccessor positions(const JsonValue &accessor);
    GltfAccessor indices(const JsonValue &accessor);

private:
    GltfAccessor access(const JsonValue &index, const char *type, std::size_t n_components);
    std::string_view buffer(const JsonValue &index);
    std::string_view view(const JsonValue &index, std::size_t &stride);
    std::string load(const JsonValue &buffer);

    JsonValue root_;
    std::optional<std::string_view> binary_;
    OpenBuffer open_;
    std::map<std::size_t, std::string> loaded_;
    std::size_t n_loaded_ = 0; ///< bytes
};

} // namespace penumbra
