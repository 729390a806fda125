// glTF files written down in a test.
#pragma once

#include "scene/read_gltf.h"

#include <nlohmann/json.hpp>

namespace penumbra {

/// A file that is put together value by value; buffer 0 holds `bytes`.
struct GltfDraft {
    nlohmann::json json = {{"asset", {{"version", "2.0"}}},          {"buffers", nlohmann::json::array()},
                           {"bufferViews", nlohmann::json::array()}, {"accessors", nlohmann::json::array()},
                           {"materials", nlohmann::json::array()},   {"meshes", nlohmann::json::array()},
                           {"nodes", nlohmann::json::array()}};
    std::string bytes;

    /// Index of a new accessor of float triples, of unsigned shorts, of float pairs.
    int vec3(const std::vector<Vec3> &values);
    int shorts(const std::vector<int> &values);
    int vec2(std::size_t n_zeros);
    /// Index of a new material, mesh of one primitive, node.
    int material(const std::string &name, const Rgb &reflectance, const Rgb &exitance = Rgb::Zero());
    int mesh(const std::vector<Vec3> &positions, const std::vector<int> &indices, int material);
    int node(const std::string &name, int mesh);

    std::string gltf() const;                                 ///< text, the buffer in it
    std::string gltf_beside(const std::string &buffer) const; ///< text that names the buffer's file
    std::string glb() const;

private:
    int accessor(std::size_t first, std::size_t count, const char *type, int component);
};

/// The faces of an axis-aligned box as triangles, two a face; `inward` for a room.
struct BoxMesh {
    std::vector<Vec3> positions;
    std::vector<int> indices;
};
BoxMesh box_mesh(const Vec3 &low, const Vec3 &high, bool inward = false);

/// The scene of the draft as text; buffers outside of it are not there.
Scene scene_of(const GltfDraft &draft);

} // namespace penumbra
