// Polygons of the meshes of a glTF file.
#pragma once

#include "scene/gltf_buffers.h"
#include "scene/skipped.h"

namespace penumbra {

struct GltfFace {
    std::vector<Vec3> corners; ///< in the mesh's frame
    std::size_t material = 0;  ///< index; the number of the file's materials for none
    std::string where;         ///< for messages: "meshes[0] triangle 12", counted over the mesh's primitives from 0
};

/// Triangles of all meshes in use together.
inline constexpr std::size_t most_triangles = 1'000'000;

/// Reads each mesh once, when it is first asked for.
class GltfMeshes {
public:
    GltfMeshes(const JsonValue &root, GltfBuffers buffers) : root_(root), buffers_(std::move(buffers)) {}

    /// The triangles of its primitives (lists, strips and fans), merged by merge_triangles. Points and lines are
    /// counted as skipped, and so are skins and morph targets. Throws BadInput as GltfBuffers does, and for an index
    /// beyond its positions, a position that is not finite, Draco compression, and more than `most_triangles`.
    const std::vector<GltfFace> &faces(const JsonValue &mesh, Skipped &skipped);

private:
    struct Triangles;
    void read_primitive(const JsonValue &primitive, Triangles &out, Skipped &skipped);

    JsonValue root_;
    GltfBuffers buffers_;
    std::map<std::size_t, std::vector<GltfFace>> read_;
    std::size_t n_triangles_ = 0;
};

} // namespace penumbra
